#include "haptics/device/yielding.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr std::uint64_t kStream = 0x5969656c64696e67u;  // apart from what else the seed decides
constexpr double kTurnOver = 1e-9;                      // rad: a turn that is over

}  // namespace

Yielding::Yielding(const YieldingDesc& desc, double tick_s, std::uint64_t seed)
    : desc_(desc),
      tick_s_(tick_s),
      kept_(math::exp(-tick_s / desc.recovery)),
      random_(seed ^ kStream),
      gain_(desc.gain * math::exp(desc.spread * random_.normal())) {
  const double reaction = desc.reaction * math::exp(desc.spread * random_.normal());
  percepts_.resize(static_cast<std::size_t>(std::lround(reaction / tick_s)) + 1);
}

void Yielding::advance(const DeviceCommand::Cues& cues) noexcept {
  turn_before_ = turn_;
  percepts_[at_] = percept_of(cues);
  at_ = (at_ + 1) % percepts_.size();
  const Percept& percept = percepts_[at_];
  if (percept.felt > 0 || percept.seen > 0) {
    turn_back(percept);
  } else {
    told_ = false;
    recover();
  }
}

Yielding::Percept Yielding::percept_of(const DeviceCommand::Cues& cues) const noexcept {
  Percept percept;
  if (cues.vibration >= desc_.least_vibration)
    percept.felt = std::min(1.0, cues.vibration / desc_.full_vibration);
  percept.seen = std::clamp(cues.ghost, 0.0, 1.0);
  percept.goal = (quaternion_exp(cues.unwind_D) * turn_).normalized();
  return percept;
}

// Along a way that errs by a fixed turn from the right one, no farther than it brings the goal nearer.
void Yielding::turn_back(const Percept& percept) noexcept {
  const Vec3 left = rotation_vector(percept.goal * turn_.conjugate());
  const double angle = left.norm();
  if (angle < kTurnOver) return;
  const Vec3 right_way = left / angle;
  if (!told_) {
    told_ = true;
    error_ = random_.normal();
    const double about = 2 * std::numbers::pi * random_.uniform();
    const Vec3 aside = right_way.unitOrthogonal();
    error_axis_ = math::cos(about) * aside + math::sin(about) * right_way.cross(aside);
  }
  const double error_rad = error_ * (percept.seen > 0 ? desc_.seen_error_rad : desc_.felt_error_rad);
  const Vec3 way = quaternion_exp(error_rad * error_axis_) * right_way;
  const double reach = gain_ * std::max(percept.felt, percept.seen) * tick_s_;
  const double step = std::min(reach, left.dot(way));
  if (step > 0) turn_ = (quaternion_exp(step * way) * turn_).normalized();
}

void Yielding::recover() noexcept {
  const Vec3 turned = rotation_vector(turn_);
  turn_ = turned.norm() < kTurnOver ? Quat::Identity() : quaternion_exp(kept_ * turned);
}

}  // namespace fulcrum
