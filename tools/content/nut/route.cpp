#include "tools/content/nut/route.h"

#include <cmath>
#include <optional>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/nut/nut_part.h"
#include "tools/content/nut/place.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double stroke = 120.0 * degree;  // of fingers before they take hold again
constexpr double stroke_time = 1.0;        // s
constexpr double grip_time = 0.2;          // s, between two
constexpr double tilt = 12.0 * degree;
constexpr double home = 12.0 * degree;                // beyond where the nut meets its seat
constexpr double before_end = nut_at_end + 0.6 * mm;  // z of the nut's middle, set before the bolt's end
constexpr double over_pipe = 44.0 * mm;               // y
constexpr double behind_pipe = 24.0 * mm;             // z

Eigen::Isometry3d pose(const Vector3d& p, double angle, double askew = 0.0) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = p;
  X.linear() = (turn_by(askew, Vector3d::UnitX()) * turn_by(angle, Vector3d::UnitZ())).toRotationMatrix();
  return X;
}

// At which the nut is in step with the thread where its face is at the bolt's end; the smallest turn.
double angle_at_end() {
  return 2.0 * pi * out_of_step(nut_at_end, 0.0) / m12_thread.pitch;
}

void go_behind_the_pipe(std::vector<RoutePose>* route) {
  const double angle = angle_at_end();
  route->push_back({.note = "start", .X_WT = pose({70 * mm, 70 * mm, 115 * mm}, angle), .dwell = 0.5});
  route->push_back({.note = "over the pipe",
                    .X_WT = pose({4 * mm, over_pipe, pipe_z}, angle),
                    .travel = 2.2,
                    .dwell = 0.3});
  route->push_back({.note = "behind the pipe",
                    .X_WT = pose({0.0, over_pipe - 4 * mm, behind_pipe}, angle),
                    .travel = 1.2});
  route->push_back(
      {.note = "before the bolt", .X_WT = pose({0.0, 0.0, behind_pipe}, angle), .travel = 1.6, .dwell = 0.4});
}

// Clockwise, until it is home. A hand that tilts the nut does so after that many strokes.
// press m: beyond where the thread has it.
void run_down(std::vector<RoutePose>* route, double press, std::optional<int> tilts_after) {
  const double from = angle_at_end();
  const double turns = (nut_at_end - nut_on_seat) / m12_thread.pitch;
  const double to = from - 2.0 * pi * turns - home;
  route->push_back(
      {.note = "at the bolt's end", .X_WT = pose({0.0, 0.0, before_end}, from), .travel = 0.8, .dwell = 0.3});
  std::string note = "run down, a stroke of the fingers at a time";
  const int strokes = static_cast<int>(std::ceil((from - to) / stroke));
  for (int i = 1; i <= strokes; ++i) {
    const double angle = std::lerp(from, to, static_cast<double>(i) / strokes);
    const Vector3d p(0.0, 0.0, nut_at_end + m12_thread.pitch * (angle - from) / (2.0 * pi) - press);
    route->push_back({.note = note,
                      .X_WT = pose(p, angle),
                      .travel = stroke_time,
                      .dwell = i == strokes ? 2.0 : grip_time});
    note.clear();
    if (i != tilts_after) continue;
    for (const double askew : {tilt, -tilt}) {
      route->push_back({.note = "askew", .X_WT = pose(p, angle, askew), .travel = 0.6, .dwell = 2.0});
      route->push_back({.note = "straight", .X_WT = pose(p, angle), .travel = 0.6, .dwell = 0.5});
    }
    note = "run on";
  }
}

}  // namespace

std::vector<RoutePose> make_route(double press) {
  std::vector<RoutePose> route;
  go_behind_the_pipe(&route);
  run_down(&route, press, std::nullopt);
  return route;
}

std::vector<RoutePose> make_tilted_route(double press) {
  std::vector<RoutePose> route;
  go_behind_the_pipe(&route);
  run_down(&route, press, 4);
  return route;
}

std::string places_yaml() {
  const double started = nut_at_end - 2.5 * m12_thread.pitch;
  return checkpoint_yaml("over the pipe", {4 * mm, over_pipe, pipe_z}, 8 * mm) +
         checkpoint_yaml("behind the pipe", {0.0, 0.0, behind_pipe}, 3 * mm) +
         checkpoint_yaml("started", {0.0, 0.0, started}, 0.6 * mm) +
         checkpoint_yaml("half way", {0.0, 0.0, 0.5 * (started + nut_on_seat)}, 0.6 * mm) +
         checkpoint_yaml("home", {0.0, 0.0, nut_on_seat}, 0.4 * mm);
}

}  // namespace fulcrum::content
