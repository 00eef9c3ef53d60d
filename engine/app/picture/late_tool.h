#pragma once
// The tool as it is when a picture of it is submitted, and how old that is once the picture is shown.

#include "engine/app/picture/bridge.h"
#include "engine/record/hand_to_pixel.h"
#include "engine/render/renderer.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::app {

class LateTool {
public:
  // For one frame: of the loop's newest tick, whatever the frame itself was made of. All must outlive it.
  render::LatePoses poses(LiveLoop& loop, FrameBridge& bridge, const Afterglow& afterglow, double time);
  // That frame was handed on just now; submission_s: what the device took for it.
  void shown(double submission_s);

  // Of all frames so far.
  std::optional<record::HandToPixel> figures() const { return meter_.figures(); }

private:
  record::FrameMoments at_;  // of the newest frame
  record::HandToPixelMeter meter_;
};

}  // namespace fulcrum::app
