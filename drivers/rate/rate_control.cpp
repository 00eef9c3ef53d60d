#include "drivers/rate/rate_control.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

// What is no number does not push.
double curve(double push) {
  return std::isfinite(push) ? std::clamp(push, -1.0, 1.0) * std::min(std::abs(push), 1.0) : 0.0;
}

Vec3 curve(const Vec3& push) {
  return {curve(push.x()), curve(push.y()), curve(push.z())};
}

}  // namespace

RateControl::RateControl(const RateControlDesc& desc, const Pose& X_WH, double tick_s)
    : desc_(desc), tick_s_(tick_s), follow_(-math::expm1(-tick_s / desc.lag)), X_WH_(X_WH) {}

const Pose& RateControl::advance(const PushedAxes& axes, const SeenFrame& seen) noexcept {
  const bool moves = !seen.rests;
  const Vec3 v_W = moves ? seen.q_WV * (desc_.heights_per_s * seen.height * curve(axes.way)) : Vec3::Zero();
  const Vec3 w_W = moves ? seen.q_WV * (desc_.full_turn * curve(axes.turn)) : Vec3::Zero();
  v_W_ += follow_ * (v_W - v_W_);
  w_W_ += follow_ * (w_W - w_W_);
  X_WH_.p += tick_s_ * v_W_;
  X_WH_.q = (quaternion_exp(tick_s_ * w_W_) * X_WH_.q).normalized();
  return X_WH_;
}

}  // namespace fulcrum
