#include "tools/content/sweep/route.h"

#include "tools/content/sweep/tablet.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double above = 18.0 * mm;
constexpr int sweeps = 3;  // to the right, and as many back
// A hand goes from rest to rest: in the middle of its way it is 15/8 as fast as on the whole of it. There it
// has the target's 200 mm/s, and the target is beside it: one way every 1.6 s.
constexpr double across = 2.0 * turn_at / 0.2 * 15.0 / 8.0;  // s: 1.2
constexpr double turning = 1.6 - across;                     // s
constexpr double down = 0.48, settled = 0.2;                 // s, before it sets out
constexpr double sphere = 6.0 * mm;

}  // namespace

std::vector<RoutePose> make_route(double press) {
  std::vector<RoutePose> route;
  const auto go = [&](const std::string& note, double x, double y, double travel, double dwell) {
    route.push_back({.note = note,
                     .X_WT = Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.0)),
                     .travel = travel,
                     .dwell = dwell,
                     .presses = y < 0.0});
  };
  go("over the glass", -turn_at, above, 0.0, 0.0);
  go("onto it", -turn_at, -press, down, settled);
  for (int i = 0; i < sweeps; ++i) {
    go("right", turn_at, -press, across, turning);
    go("left", -turn_at, -press, across, turning);
  }
  go("off", -turn_at, above, 0.5, 0.4);
  return route;
}

std::string sweeps_yaml() {
  std::string text;
  for (int i = 1; i <= sweeps; ++i) {
    const std::string right = "right " + std::to_string(i), left = "left " + std::to_string(i);
    text += checkpoint_yaml(right, turn_at * Vector3d::UnitX(), sphere, left);
    text += checkpoint_yaml(left, -turn_at * Vector3d::UnitX(), sphere, right);
  }
  return text + checkpoint_yaml("off again", {-turn_at, above, 0.0}, sphere);
}

}  // namespace fulcrum::content
