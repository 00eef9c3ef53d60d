#include "engine/record/hand_to_pixel.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::record {
namespace {

constexpr auto kSteps = static_cast<std::size_t>(HandToPixelMeter::kMost / HandToPixelMeter::kStep);
constexpr std::size_t kCurve = 100;  // points

}  // namespace

HandToPixelMeter::HandToPixelMeter() {
  for (Counts& counts : counts_) counts.frames.resize(kSteps);
}

void HandToPixelMeter::add(const FrameMoments& at) {
  const std::array<std::int64_t, kStageNames.size()> took_ns = {at.ticked - at.sampled, at.taken - at.ticked,
                                                                at.drawn - at.taken, at.shown - at.drawn,
                                                                at.shown - at.sampled};
  for (std::size_t i = 0; i < took_ns.size(); ++i) {
    const double ms = 1e-6 * static_cast<double>(std::max<std::int64_t>(took_ns[i], 0));
    ++counts_[i].frames[std::min(static_cast<std::size_t>(ms / kStep), kSteps - 1)];
    counts_[i].largest_ms = std::max(counts_[i].largest_ms, ms);
  }
  ++frames_;
}

std::optional<HandToPixel> HandToPixelMeter::figures() const {
  if (frames_ == 0) return std::nullopt;
  HandToPixel figures{frames_, {}};
  std::ranges::transform(counts_, figures.stages.begin(),
                         [this](const Counts& counts) { return figures_of(counts); });
  return figures;
}

StageFigures HandToPixelMeter::figures_of(const Counts& counts) const {
  const auto all = static_cast<double>(frames_);
  StageFigures figures{0, 0, counts.largest_ms, {}};
  std::int64_t so_far = 0;
  std::size_t points = 0;  // of the curve that have been passed
  for (std::size_t i = 0; i < kSteps; ++i) {
    if (counts.frames[i] == 0) continue;
    if (so_far == 0) figures.within.push_back({kStep * static_cast<double>(i), 0});
    const bool last = i + 1 == kSteps;
    const double end =
        last ? counts.largest_ms : std::min(kStep * static_cast<double>(i + 1), counts.largest_ms);
    const double before = static_cast<double>(so_far) / all;
    so_far += counts.frames[i];
    const double part = static_cast<double>(so_far) / all;
    if (before < 0.5 && part >= 0.5) figures.p50_ms = end;
    if (before < 0.99 && part >= 0.99) figures.p99_ms = end;
    if (const auto passed = static_cast<std::size_t>(part * kCurve); passed > points) {
      figures.within.push_back({end, part});
      points = passed;
    }
  }
  return figures;
}

}  // namespace fulcrum::record
