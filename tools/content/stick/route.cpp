#include "tools/content/stick/route.h"

#include <cmath>
#include <string>

#include "tools/content/stick/stick.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double above = 28.0 * mm;  // over the ball, between touches
constexpr double at_middle = 100.0 * mm;
constexpr double grip = 2.5;                                     // N, on the strip
constexpr double down = 0.6, up = 0.5, aside = 0.6, rest = 0.4;  // s
constexpr double sphere = 5.0 * mm;      // radius of a checkpoint: a stick that lies on the ball is in it
constexpr double end_sphere = 6.0 * mm;  // of one in the air
constexpr double wanted = 4.0 * mm;      // depth of its middle

// The stage, where the ball is touched at `place` along the stick and the stick is `height` over it.
Vector3d stage(double place, double height) {
  return {-place, stick_radius + height, 0.0};
}

std::string at_mm(double place) {
  return "touch at " + std::to_string(std::lround(place / mm)) + " mm";
}

constexpr double touches[] = {80.0 * mm, 60.0 * mm, 100.0 * mm};

}  // namespace

std::vector<RoutePose> make_route(double depth) {
  std::vector<RoutePose> route;
  double held = at_middle;
  const auto go = [&](const std::string& note, double place, double height, double travel, double dwell) {
    RoutePose pose{.note = note, .X_WT = Eigen::Isometry3d::Identity(), .travel = travel, .dwell = dwell};
    pose.X_WT.translation() = stage(place, height);
    pose.hold = held;
    pose.press = grip;
    pose.presses = height < 0.0;
    route.push_back(pose);
  };
  go("over the ball, held in the middle", touches[0], above, 0.0, rest);
  for (const double place : touches) {
    if (place != touches[0]) go("", place, above, aside, 0.1);
    go(at_mm(place), place, -depth, down, rest);
    go("", place, above, up, 0.0);
  }
  go("", touches[0], above, aside, 0.1);
  go("down once more, and the hand goes along the stick and back", touches[0], -depth, down, rest);
  for (const double place : {140.0 * mm, 60.0 * mm, at_middle}) {
    held = place;
    go("", touches[0], -depth, 0.9, 0.3);
  }
  go("off", touches[0], above, up, rest);
  return route;
}

std::string touches_yaml() {
  std::string text;
  const auto at = [](double place, double height) {
    return Vector3d(stage(place, height) + at_middle * Vector3d::UnitX());
  };
  for (const double place : touches) text += checkpoint_yaml(at_mm(place), at(place, -wanted), sphere);
  text += checkpoint_yaml("up", at(touches[0], above), end_sphere);
  text += checkpoint_yaml("hold elsewhere", at(touches[0], -wanted), sphere);
  return text + checkpoint_yaml("off again", at(touches[0], above), end_sphere);
}

}  // namespace fulcrum::content
