#pragma once
// From the hand to the picture: how old the tool's pose is by the time a frame with it is shown, and what of
// that is whose.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace fulcrum::record {

// Moments of one frame, by AgeClock (ns).
struct FrameMoments {
  std::int64_t sampled = 0;  // the device measured the pose that is drawn
  std::int64_t ticked = 0;   // the tick with it had ended
  std::int64_t taken = 0;    // the picture took that tick's pose, and was submitted
  std::int64_t drawn = 0;    // the graphics device was done
  std::int64_t shown = 0;    // the picture was handed to the screen, or to a headset
};

// One after the other; the last is all of them.
enum class Stage { tick, wait, draw, show, whole };
inline constexpr std::array kStageNames =
    std::to_array<std::string_view>({"tick", "wait", "draw", "show", "whole"});

// Of all frames. Nearest rank, and too large by less than HandToPixelMeter::kStep.
struct StageFigures {
  double p50_ms = 0, p99_ms = 0, max_ms = 0;
  std::vector<std::array<double, 2>> within;  // (at most 101 x 2): ms, and the part of the frames within that
};

struct HandToPixel {
  std::int64_t frames = 0;
  std::array<StageFigures, kStageNames.size()> stages;

  const StageFigures& of(Stage stage) const { return stages[static_cast<std::size_t>(stage)]; }
};

// Counts frames in bounded memory.
class HandToPixelMeter {
public:
  static constexpr double kStep = 0.1;   // ms
  static constexpr double kMost = 1000;  // ms: what takes longer counts as that, but for the largest

  HandToPixelMeter();

  void add(const FrameMoments& at);
  // None: no frame was counted.
  std::optional<HandToPixel> figures() const;

private:
  struct Counts {
    std::vector<std::uint32_t> frames;  // by steps
    double largest_ms = 0;
  };
  StageFigures figures_of(const Counts& counts) const;

  std::int64_t frames_ = 0;
  std::array<Counts, kStageNames.size()> counts_;
};

}  // namespace fulcrum::record
