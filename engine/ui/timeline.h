#pragma once
// A trial from its beginning to its end, and the moment of it that is shown.

#include <optional>
#include <string>
#include <vector>

#include "engine/render/plan.h"

namespace fulcrum::ui {

struct OverlayState;

struct Timeline {
  struct Mark {
    enum class Kind { good, fair, bad };
    double time_s = 0.0;
    Kind kind = Kind::fair;
  };
  double end_s = 0.0;
  std::optional<double> at_s;  // none: no moment of it is shown
  std::vector<Mark> marks;
  std::string caption;
};

// The time at that place of the bar; none: the place is not on it. dragged: beside it is on it, too. x, y:
// fractions of the picture's height, from its top left.
std::optional<double> timeline_time(const OverlayState& state, render::Extent picture, double x, double y,
                                    bool dragged);

}  // namespace fulcrum::ui
