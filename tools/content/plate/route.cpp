#include "tools/content/plate/route.h"

#include <algorithm>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/plate/faces.h"
#include "tools/content/plate/stylus.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double rest_lean = 45.0 * degree;  // of the stylus to the left, as the device holds it
constexpr double tap_height = 30.0 * mm;     // over the face, from where a tap begins
constexpr double down = 0.32;                // s: the tip meets the face with 0.15 m/s
constexpr double up = 0.5;                   // s
constexpr double rest = 0.4;                 // s, before a tap
constexpr double pace = 0.12;                // m/s, from tap to tap
constexpr double end_sphere = 5.0 * mm;
constexpr double sphere = 2.0 * mm;  // radius of a checkpoint

// From upright to the left, then about the vertical towards the trainee.
Vector3d leaning(double left, double forward) {
  return turn_by(forward, Vector3d::UnitY()) * Vector3d(-math::sin(left), math::cos(left), 0.0);
}

// The rod's z axis along a direction, by the shortest turn from how the handle holds it at rest.
Eigen::Matrix3d held(const Vector3d& stylus_W) {
  const Vector3d at_rest_W = leaning(rest_lean, 0.0);
  const auto q_rest = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), at_rest_W);
  return (Eigen::Quaterniond::FromTwoVectors(at_rest_W, stylus_W) * q_rest).toRotationMatrix();
}

}  // namespace

std::vector<Tap> make_taps() {
  const auto all = faces();
  const auto tap = [&](const char* name, std::size_t face, double along, double z, double left,
                       double forward) {
    const Face& f = all[face];
    return Tap{name, f.centre_W + along * f.along_W() + z * Vector3d::UnitZ(), f.nhat_W,
               leaning(left, forward)};
  };
  return {
      tap("level", 0, 0.0, 0.0, rest_lean, 0.0),
      tap("level and steep", 0, 16 * mm, 12 * mm, 15 * degree, 0.0),
      tap("level and low", 0, -10 * mm, 14 * mm, 65 * degree, 30 * degree),
      tap("tilted by 30", 1, 0.0, 0.0, 30 * degree, 0.0),  // along the normal
      tap("tilted by 60", 2, 0.0, 0.0, rest_lean, 40 * degree),
      tap("upright", 3, 4 * mm, 0.0, rest_lean, 0.0),
  };
}

std::vector<RoutePose> make_route(const std::vector<Tap>& taps, double press) {
  std::vector<RoutePose> route;
  const auto go = [&](const std::string& note, const Tap& tap, double above, double travel, double dwell) {
    RoutePose pose{.note = note, .X_WT = Eigen::Isometry3d::Identity(), .travel = travel, .dwell = dwell};
    pose.X_WT.linear() = held(tap.stylus_W);
    pose.X_WT.translation() = tap.p_W + (stylus_tip_radius + above) * tap.nhat_W;
    route.push_back(pose);
  };
  for (const Tap& tap : taps) {
    double travel = 0.0;
    if (!route.empty()) {
      const Vector3d over = tap.p_W + (stylus_tip_radius + tap_height) * tap.nhat_W;
      travel = std::max(0.5, (over - route.back().X_WT.translation()).norm() / pace);
    }
    go("over: " + tap.name, tap, tap_height, travel, rest);
    go(tap.name, tap, -press, down, 0.0);
    route.back().presses = true;
    go("", tap, tap_height, up, 0.0);
  }
  return route;
}

std::string taps_yaml(const std::vector<Tap>& taps) {
  std::string text;
  for (const Tap& tap : taps)
    text += checkpoint_yaml(tap.name, tap.p_W + stylus_tip_radius * tap.nhat_W, sphere);
  // A run ends with the last checkpoint: it is over the last plate, so that the last tap is felt to its end.
  const Tap& last = taps.back();
  return text +
         checkpoint_yaml("off again", last.p_W + (stylus_tip_radius + tap_height) * last.nhat_W, end_sphere);
}

}  // namespace fulcrum::content
