#pragma once
// A second view of the scene beside the one that is looked from, and marks of touch in either.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/app/picture/touches.h"
#include "engine/render/plan.h"
#include "engine/scenario/scenario.h"
#include "engine/ui/target_state.h"

namespace fulcrum::app {

struct ChosenView {
  std::string name;
  render::Camera camera;
};

// What tells most of the depth that `from` does not: of the scenario's views the one whose direction is the
// most square to it, where one is by 45 degrees at least; else the same place seen from its right side.
ChosenView second_view(const render::Camera& from, std::span<const scenario::View> views);

// As a camera sees them, the hardest few. picture: px that the marks' places are in. limit: N, of the scene.
std::vector<ui::TouchMark> touch_marks(const render::Camera& camera, render::Extent picture,
                                       std::span<const Touch> touches, double limit);

// The same in fractions of the picture's width and height.
std::vector<ui::TouchMark> in_fractions(std::vector<ui::TouchMark> marks, render::Extent picture);

}  // namespace fulcrum::app
