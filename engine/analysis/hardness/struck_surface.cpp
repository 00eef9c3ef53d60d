#include "engine/analysis/hardness/struck_surface.h"

#include <algorithm>

#include "engine/analysis/simulated_wall.h"

namespace fulcrum::analysis::hardness {

std::vector<double> struck_forces(const DeviceDesc& device, const StrikeSetting& setting, double pulse) {
  const WallLoop loop{.axis = {.mass = setting.hand_mass + device.handle_mass,
                               .damping = device.damping,
                               .friction = device.friction,
                               .encoder_step = 0},
                      .tick_s = setting.tick_s,
                      .delay_ticks = 0,
                      .filter_pole = 0};
  SimulatedWall surface(loop, {.K = setting.stiffness, .B = 0}, setting.speed);
  std::vector<double> forces;
  for (int tick = 0; tick < kStruckTicks && surface.v() > 0; ++tick) {
    surface.tick(tick < setting.ticks ? -pulse : 0.0);
    forces.push_back(-surface.force());
  }
  return forces;
}

double extended_rate_hardness(const std::vector<double>& forces, const StrikeSetting& setting) {
  double steepest = 0, before = 0;
  for (const double force : forces) {
    steepest = std::max(steepest, (force - before) / setting.tick_s);
    before = force;
  }
  return steepest / setting.speed;
}

}  // namespace fulcrum::analysis::hardness
