#include "haptics/estimate/encoder_motion.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr int kAtRest = 1000;  // ticks without a count; what went before has no say

}  // namespace

void EncoderMotion::update(const Vec6& d) noexcept {
  for (Eigen::Index i = 0; i < 6; ++i) {
    int& since = since_[static_cast<std::size_t>(i)];
    since = std::min(since + 1, kAtRest);
    if (d[i] == 0.0) {
      within_[i] = 0.0;
      const double overdue = std::abs(last_[i]) / (since + 1);
      rate_[i] = since == kAtRest ? 0.0 : std::clamp(rate_[i], -overdue, overdue);
      continue;
    }
    const bool one_count = std::abs(d[i]) < kOneCount * step_[i];
    const bool onward = d[i] * last_[i] > 0.0;
    if (!one_count)
      within_[i] = d[i];
    else
      within_[i] = onward ? d[i] / since : 0.0;
    rate_[i] = within_[i];
    last_[i] = d[i];
    since = 0;
  }
}

void EncoderMotion::jump(const Vec6& d) noexcept {
  within_ = d;
  rate_.setZero();
  last_.setZero();
  since_.fill(0);
}

}  // namespace fulcrum
