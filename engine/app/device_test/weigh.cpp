#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "engine/app/device_test/calibrate.h"
#include "haptics/math/functions.h"

namespace fulcrum::app::device_test {
namespace {

// The servo: as fast as a slow hand, and much softer than any wall that a device can hold.
constexpr double kServoRate = 60;      // rad/s, of handle and spring
constexpr double kStiffest = 100;      // N/m
constexpr double kDampingRatio = 0.7;  // of critical damping
constexpr double kSmoothing = 5e-3;    // s, time constant of the velocity's low-pass
constexpr double kSinks = 1.2;         // s, in which the force ramps in, too
constexpr double kStroke = 1.5;        // s, up, and as long down
constexpr double kAllOfIt = 0.95;      // of what the bench pushes at most
constexpr double kSkip = 0.4;          // of a stroke, at its beginning, in which it turns round
constexpr int kStrokes = 3;            // up and down

class Servo {
public:
  Servo(const DeviceDesc& device, double tick_s)
      : stiffness_(std::min(kStiffest, device.handle_mass * kServoRate * kServoRate)),
        damping_(2 * kDampingRatio * std::sqrt(stiffness_ * device.handle_mass)),
        pole_(math::exp(-tick_s / kSmoothing)),
        tick_s_(tick_s) {}

  // (3) N on the handle, that leads it from p_D to p_wanted_D (3) m.
  Vec3 process(const Vec3& p_D, const Vec3& p_wanted_D) {
    if (!known_) last_D_ = p_D;
    known_ = true;
    velocity_D_ = pole_ * velocity_D_ + (1 - pole_) / tick_s_ * (p_D - last_D_);
    last_D_ = p_D;
    return stiffness_ * (p_wanted_D - p_D) - damping_ * velocity_D_;
  }

  double speed() const { return velocity_D_.norm(); }  // m/s, of the handle

private:
  double stiffness_, damping_, pole_, tick_s_;
  Vec3 last_D_ = Vec3::Zero(), velocity_D_ = Vec3::Zero();
  bool known_ = false;
};

struct Stroke {
  double pushed = 0;  // N up, in the mean
  double uneven = 0;  // N, between the halves of the ticks that are taken
  double ended = 0;   // m, y at its end
};

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

std::optional<Weighing> weigh(TestBench& bench) {
  Servo servo(bench.desc(), bench.tick_s());
  BenchTick now = bench.tick();
  const Vec3 middle_D = now.sample.X_DH.p;
  Weighing weighing;
  double pressed_since = now.time;  // s, when the bench last pushed with less than all
  const auto ended = [&] { return weighing.astray ? std::optional(weighing) : std::nullopt; };
  // One way from one height to another, both from the middle, within a time.
  const auto lead = [&](double from, double to, double seconds) -> std::optional<Stroke> {
    const double begun = now.time;
    Stroke stroke;
    std::vector<double> pushed;
    while (now.time - begun < seconds) {
      const double part = std::min(1.0, (now.time - begun) / seconds);
      const Vec3 wanted_D = middle_D + Vec3(0, from + part * (to - from), 0);
      now = bench.tick({servo.process(now.sample.X_DH.p, wanted_D), Vec3::Zero()});
      if (bench.over()) return std::nullopt;
      const bool whole = now.commanded_F_H_D.force.norm() > kAllOfIt * bench.budget().force;
      if (!whole) pressed_since = now.time;
      weighing.astray = (now.sample.X_DH.p - wanted_D).norm() > kAstray || servo.speed() > kRuns ||
                        now.time - pressed_since > kPressed;
      if (weighing.astray) return std::nullopt;
      const double up = now.commanded_F_H_D.force.y();
      weighing.most = std::max(weighing.most, now.commanded_F_H_D.force.norm());
      if (part >= kSkip) pushed.push_back(up);
    }
    if (pushed.size() < 2) return std::nullopt;
    stroke.pushed = mean(pushed);
    const std::span all(pushed);
    stroke.uneven = std::abs(mean(all.last(all.size() / 2)) - mean(all.first(all.size() / 2)));
    stroke.ended = now.sample.X_DH.p.y();
    return stroke;
  };
  constexpr double high = kWeighingWay / 2;
  if (!lead(0, -high, kSinks)) return ended();
  weighing.most = 0;
  std::vector<double> weights, frictions, ways;
  for (int i = 0; i < kStrokes; ++i) {
    const std::optional<Stroke> up = lead(-high, high, kStroke);
    const std::optional<Stroke> down = up ? lead(high, -high, kStroke) : std::nullopt;
    if (!down) return ended();
    weights.push_back((up->pushed + down->pushed) / 2);
    frictions.push_back((up->pushed - down->pushed) / 2);
    ways.push_back(up->ended - down->ended);
    weighing.uneven = std::max({weighing.uneven, up->uneven, down->uneven});
  }
  weighing.weight = mean(weights);
  weighing.friction = mean(frictions);
  weighing.spread = *std::ranges::max_element(weights) - *std::ranges::min_element(weights);
  weighing.moved = mean(ways);
  return weighing;
}

}  // namespace fulcrum::app::device_test
