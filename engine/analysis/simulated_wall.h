#pragma once
// The wall loop as the simulated device runs it: its own friction, encoder counts, hold and sample age. The
// force limit is lifted: a clamp bounds what diverges and makes nothing stable.

#include <vector>

#include "haptics/device/simulated_device.h"
#include "haptics/device/wall_loop.h"

namespace fulcrum::analysis {

class SimulatedWall {
public:
  // From 0 at v0 m/s, in no hand. The wall's zero lies between two encoder counts, which is the worst case:
  // at rest the device feels K D / 2 one way or the other, and trembles if friction does not hold that.
  SimulatedWall(const WallLoop& loop, const Wall& wall, double v0);

  void tick(double added = 0) noexcept;                   // N, a force beside the wall's
  double x() const { return device_.X_DH().p.x(); }       // m, the true place
  double v() const { return device_.velocity().x(); }     // m/s
  double counted() { return device_.read().X_DH.p.x(); }  // m, what the law sees at the next tick
  double force() const { return force_; }                 // N, of the last tick

private:
  Wall wall_;
  double tick_s_;
  double rest_;  // m, the wall's zero
  SimulatedDevice device_;
  double filter_pole_;
  double before_ = 0;
  double velocity_ = 0;  // m/s, as estimated
  double force_ = 0;
};

// What came of a swing of many cycles.
struct Swing {
  double growth = 0;  // 1/s, over the last half: of the root mean square of x
  double early = 0;   // m, from its least to its largest x in the first third
  double late = 0;    // m, the same in the last third; infinite if it was broken off
};
Swing swing(const WallLoop& loop, const Wall& wall, double v0);

// Of a linear axis: decays. Of any other: swings less far at the end than at the beginning. It may tremble on
// by some encoder counts.
bool settles(const WallLoop& loop, const Wall& wall, double v0);

// N/m, the largest stiffness at which settles() holds, to half a per cent; 0 if it holds at none above
// .1 N/m.
double simulated_stiffness_limit(const WallLoop& loop, double B, double v0);

// J, what the hand's side put into the wall up to each tick, by the passivity observer (haptics/safety):
// below 0 the wall has made energy.
std::vector<double> port_energy(const WallLoop& loop, const Wall& wall, double v0, int ticks);

}  // namespace fulcrum::analysis
