#pragma once
// Moments of a scenario, drawn as the program draws them, against goldens. To look at new ones: run, open
// tests/failures in the build folder, and copy *.actual.png over the golden if that is what the change was
// for; say why in the commit.

#include <span>
#include <string>

#include "engine/app/picture/picture.h"

namespace fulcrum::test {

// The tool where the route of the hand `expert` has it at `time` (s), dwelling at the checkpoint `step`: it
// does not depend on a run.
app::FrameInput input_on_route(const app::Prepared& prepared, double time, std::size_t step);

// The hand has turned on by `angle_rad` about an axis of T through its origin while the tool stayed, and the
// ghost is there.
void turn_on(const app::Prepared& prepared, const Vec3& axis_T, double angle_rad, TickRecord& record);

// The moment from a view of that name, against FULCRUM_GOLDENS/`golden`.png.
void expect_golden(const app::Prepared& prepared, app::FrameInput input, const std::string& view,
                   const std::string& golden);

// A view, and when the tool is to be seen in it: at the checkpoint `step`.
struct Shot {
  const char* view;
  double time;  // s
  std::size_t step;
};

// Each against the golden of its view's name.
void expect_goldens(const app::Prepared& prepared, std::span<const Shot> shots);

// Each against VIEW_ghost: the hand has rolled on about the line from the model's origin, the tip, to the
// centre of mass.
void expect_ghost_goldens(const app::Prepared& prepared, std::span<const Shot> shots);

}  // namespace fulcrum::test
