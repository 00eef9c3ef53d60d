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
  // A curve over the trial, below the bar: the largest value of each interval, so that no peak is lost.
  struct Plot {
    std::string name, unit;
    std::vector<double> largest;    // (n), in the unit
    double interval_s = 0.0;        // of each of them
    std::optional<double> limit{};  // in the unit; none: there is none
  };
  double end_s = 0.0;
  std::optional<double> at_s;  // none: no moment of it is shown
  std::vector<Mark> marks;
  std::string caption;
  bool has_expert = false;    // who may be seen beside it
  std::vector<Plot> plots{};  // the first ones are shown, as many as the picture has room for
};

// The time at that place of the bar or of a plot below it; none: the place is on neither. dragged: beside
// them is on them, too. x, y:
// fractions of the picture's height, from its top left.
std::optional<double> timeline_time(const OverlayState& state, render::Extent picture, double x, double y,
                                    bool dragged);

}  // namespace fulcrum::ui
