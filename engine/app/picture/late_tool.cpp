#include "engine/app/picture/late_tool.h"

#include "haptics/loop/age_clock.h"

namespace fulcrum::app {

render::LatePoses LateTool::poses(LiveLoop& loop, FrameBridge& bridge, const Afterglow& afterglow,
                                  double time) {
  at_ = {};
  return [this, &loop, &bridge, &afterglow, time] {
    const TimedTick& newest = loop.newest_timed();
    const std::span<const glm::mat4> X_WM = bridge.poses(newest.record, afterglow, time);
    at_ = {newest.sampled_ns, newest.at_ns, AgeClock::now_ns(), 0, 0};
    return X_WM;
  };
}

void LateTool::shown(double submission_s) {
  if (at_.taken == 0) return;  // nothing in the scene moves
  at_.drawn = at_.taken + static_cast<std::int64_t>(1e9 * submission_s);
  at_.shown = AgeClock::now_ns();
  meter_.add(at_);
}

}  // namespace fulcrum::app
