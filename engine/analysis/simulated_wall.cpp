#include "engine/analysis/simulated_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "haptics/math/bisect.h"
#include "haptics/math/functions.h"
#include "haptics/safety/passivity_observer.h"

namespace fulcrum::analysis {
namespace {

constexpr double kCycles = 40;
constexpr int kFewestTicks = 2000;
constexpr double kBrokenOff = 1e4;  // times the undamped amplitude
constexpr double kSoftest = 0.1;    // N/m
constexpr double kPrecision = 5e-3;

SimulatedDeviceDesc device_of(const WallLoop& loop) {
  SimulatedDeviceDesc desc;
  desc.device.handle_mass = loop.axis.mass;
  desc.device.damping = loop.axis.damping;
  desc.device.friction = loop.axis.friction;
  desc.device.encoder_step = loop.axis.encoder_step;
  desc.device.max_force = std::numeric_limits<double>::infinity();
  desc.tick_s = loop.tick_s;
  desc.sample_age_ticks = loop.delay_ticks;
  return desc;
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  void take(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
};

// 1 - cos over `ticks`, from 0 to 0, until the next call: most swings are as long as the one before.
const std::vector<double>& bell(int ticks) {
  thread_local std::vector<double> kept;
  if (std::ssize(kept) != ticks) {
    kept.resize(static_cast<std::size_t>(ticks));
    for (int i = 0; i < ticks; ++i)
      kept[static_cast<std::size_t>(i)] = 1 - math::cos(2 * std::numbers::pi * (i + 0.5) / ticks);
  }
  return kept;
}

// Sum of x^2 under a bell over a stretch: the swing within a cycle cancels, and the ratio of two stretches
// is the growth between their middles.
class Stretch {
public:
  Stretch(int from, const std::vector<double>& bell) : from_(from), bell_(bell) {}
  void take(int tick, double x) {
    const auto i = static_cast<std::size_t>(tick - from_);
    if (tick >= from_ && i < bell_.size()) sum_ += bell_[i] * x * x;
  }
  double sum() const { return sum_; }

private:
  int from_;
  const std::vector<double>& bell_;
  double sum_ = 0;
};

}  // namespace

SimulatedWall::SimulatedWall(const WallLoop& loop, const Wall& wall, double v0)
    : wall_(wall),
      tick_s_(loop.tick_s),
      rest_(loop.axis.encoder_step / 2),
      device_(device_of(loop), Pose{}),
      filter_pole_(loop.filter_pole) {
  device_.push({v0, 0, 0});
}

void SimulatedWall::tick(double added) noexcept {
  const double x = counted();
  velocity_ = filter_pole_ * velocity_ + (1 - filter_pole_) * (x - before_) / tick_s_;
  force_ = -wall_.K * (x - rest_) - wall_.B * velocity_ + added;
  before_ = x;
  device_.write({.F_H_D = {Vec3(force_, 0, 0), Vec3::Zero()}});
}

Swing swing(const WallLoop& loop, const Wall& wall, double v0) {
  const double w = std::sqrt(wall.K / loop.axis.mass), amplitude = std::abs(v0) / w;
  const int ticks = std::max(
      kFewestTicks, static_cast<int>(std::lround(2 * std::numbers::pi * kCycles / (w * loop.tick_s))));
  const int quarter = ticks / 4;
  const std::vector<double>& weights = bell(quarter);
  Stretch before(2 * quarter, weights), after(3 * quarter, weights);
  SimulatedWall run(loop, wall, v0);
  Range early, late;
  for (int i = 0; i < ticks; ++i) {
    run.tick();
    const double x = run.x();
    if (!(std::abs(x) < kBrokenOff * amplitude)) {
      constexpr double far = std::numeric_limits<double>::infinity();
      return {math::log(kBrokenOff) / ((i + 1) * loop.tick_s), early.most - early.least, far};
    }
    if (i < ticks / 3) early.take(x);
    if (i >= ticks - ticks / 3) late.take(x);
    before.take(i, x);
    after.take(i, x);
  }
  Swing result;
  result.early = early.most - early.least;
  result.late = late.most - late.least;
  result.growth = after.sum() > 0 ? 0.5 * math::log(after.sum() / before.sum()) / (quarter * loop.tick_s)
                                  : -std::numeric_limits<double>::infinity();  // it came to rest at 0
  return result;
}

bool settles(const WallLoop& loop, const Wall& wall, double v0) {
  const Swing end = swing(loop, wall, v0);
  return loop.axis.linear() ? end.growth < 0 : end.late < end.early;
}

double simulated_stiffness_limit(const WallLoop& loop, double B, double v0) {
  // An undamped mass on a spring that is integrated by ticks flies apart at 4 m / T^2.
  const double unstable = 4 * loop.axis.mass / (loop.tick_s * loop.tick_s);
  return end_below(unstable, kSoftest, kPrecision, [&](double K) { return settles(loop, {K, B}, v0); });
}

std::vector<double> port_energy(const WallLoop& loop, const Wall& wall, double v0, int ticks) {
  Vec6 step = Vec6::Zero();
  step[0] = loop.axis.encoder_step;
  PassivityObserver observer(step, true, false);
  PassivityObserver::Port port;
  port.open = true;
  observer.update(Vec6::Zero(), port);
  SimulatedWall run(loop, wall, v0);
  std::vector<double> energy;
  double x = run.counted();
  for (int i = 0; i < ticks; ++i) {
    Vec6 d = Vec6::Zero();
    d[0] = run.counted() - x;
    x = run.counted();
    run.tick();
    port.F_H_D.force.x() = run.force();
    observer.update(d, port);
    energy.push_back(observer.port());
  }
  return energy;
}

}  // namespace fulcrum::analysis
