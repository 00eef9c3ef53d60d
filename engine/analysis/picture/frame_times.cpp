#include "engine/analysis/picture/frame_times.h"

#include <algorithm>

namespace fulcrum::analysis::picture {

Result<FrameTimes> FrameTimes::by_turns(std::size_t levels,
                                        const std::function<Result<double>(std::size_t)>& draw) {
  FrameTimes times(levels);
  while (!times.are_enough()) {
    for (std::size_t level = 0; level < levels; ++level) {
      const Result<double> frame_s = draw(level);
      if (!frame_s) return frame_s.error();
      times.add(*frame_s);
    }
  }
  return times;
}

void FrameTimes::add(double frame_s) {
  if (next_ == 0) counts_ = rounds_ >= kUncounted && uncounted_s_ >= kUncounted_s;
  if (counts_) times_[next_].push_back(frame_s);
  (counts_ ? counted_s_ : uncounted_s_) += frame_s;
  next_ = (next_ + 1) % times_.size();
  if (next_ == 0) ++rounds_;
}

bool FrameTimes::are_enough() const {
  return next_ == 0 && times_[0].size() >= kRounds && counted_s_ >= kCounted_s;
}

double FrameTimes::median_ms(std::size_t level) const {
  std::vector<double> counted = times_[level];
  const auto middle = counted.begin() + static_cast<std::ptrdiff_t>(counted.size() / 2);
  std::ranges::nth_element(counted, middle);
  return 1e3 * *middle;
}

}  // namespace fulcrum::analysis::picture
