#include "engine/app/window/eye_pointer.h"

#include <utility>

namespace fulcrum::app {

EyePointer::Move EyePointer::move(const std::optional<render::StereoMode>& mode, double aspect,
                                  const glm::dvec2& at, bool held) {
  const bool beside = mode == render::StereoMode::side_by_side,
             above = mode == render::StereoMode::top_bottom;
  const glm::dvec2 second_begins(beside ? 0.5 * aspect : 0.0, above ? 0.5 : 0.0);
  const glm::dvec2 stretch(beside ? 2.0 : 1.0, above ? 2.0 : 1.0);
  if (!held) second_ = (beside && at.x >= second_begins.x) || (above && at.y >= second_begins.y);
  const glm::dvec2 in_half = second_ ? at - second_begins : at;
  return {stretch * in_half, stretch * (at - std::exchange(last_, at))};
}

}  // namespace fulcrum::app
