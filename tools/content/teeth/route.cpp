#include "tools/content/teeth/route.h"

#include <algorithm>

#include "haptics/math/rotation.h"
#include "tools/content/teeth/explorer.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double gap = 0.05 * mm;    // left between the tip and what it is let down to
constexpr double press = 0.25 * mm;  // how far beyond that the hand aims
constexpr double hover = 9.0 * mm;   // y at which the tip goes from one place to the next
constexpr double above = 2.0 * mm;   // over a stop, where it slows down
constexpr double sphere = 1.0 * mm;  // radius of a checkpoint
constexpr double slow = 0.004;       // m/s
constexpr double fast = 0.025;       // m/s
const Vector3d start(0.0, 18 * mm, 42 * mm);

// Straight down from above the teeth until the tip has only the gap left.
Vector3d let_down(const Vector3d& from, const TriangleTree& scene) {
  const double wanted = explorer_tip_radius + gap;
  Vector3d p = from;
  for (int step = 0; step < 4000; ++step) {
    const double room = scene.distance(p, 5 * mm) - wanted;
    if (room < 0.002 * mm) break;
    p.y() -= std::max(0.5 * room, 0.002 * mm);
  }
  return p;
}

// Over the pit of a tooth, at a place in its own coordinates (mm).
Vector3d over(const Tooth& tooth, double x, double y) {
  Vector3d p = tooth.to_world({x, y, tooth.design.relief.height(x, y)}) * mm;
  p.y() = 5 * mm;
  return p;
}

// Before the space between two teeth, this far (mm) to the cheek from where they touch.
Vector3d beside(const Dentition& dentition, int number_a, int number_b, double out) {
  const Tooth& a = dentition.tooth(number_a);
  const Tooth& b = dentition.tooth(number_b);
  const auto touching = [](const Tooth& t) {
    return t.to_world({0.0, 0.0, t.design.contact * t.crown_length});
  };
  const double share = a.half_width / (a.half_width + b.half_width);
  const Vector3d middle = touching(a) + share * (touching(b) - touching(a));
  const Arch::Place place = dentition.arch.at(a.along + share * (b.along - a.along));
  return Vector3d(middle.x() + out * place.outward.x(), 5.0, middle.z() + out * place.outward.y()) * mm;
}

// What a stop is called in the mirror image of the jaw: its teeth's numbers begin with 4 on the right, and
// with 3 on the left (ISO 3950).
std::string mirrored(std::string name) {
  const auto is_digit = [&name](std::size_t i) {
    return i < name.size() && name[i] >= '0' && name[i] <= '9';
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_digit(i) || !is_digit(i + 1)) continue;
    name[i] = name[i] == '4' ? '3' : '4';
    ++i;
  }
  return name;
}

}  // namespace

std::vector<Stop> make_stops(const Dentition& dentition, const TriangleTree& scene) {
  const auto stop = [&](const char* name, const Vector3d& from, double yaw) {
    return Stop{name, let_down(from, scene), yaw};
  };
  return {
      stop("fissure of 46", over(dentition.tooth(46), 0.0, 0.0), -12 * degree),
      stop("space 46/45", beside(dentition, 46, 45, 3.75), -20 * degree),
      stop("space 43/42", beside(dentition, 43, 42, 2.05), -10 * degree),
      stop("pit of 35", over(dentition.tooth(35), -0.9, -0.9), 12 * degree),
      stop("space 36/37", beside(dentition, 36, 37, 3.95), 20 * degree),
      stop("fissure of 37", over(dentition.tooth(37), 0.0, 0.0), 12 * degree),
  };
}

std::vector<RoutePose> make_route(const std::vector<Stop>& stops) {
  std::vector<RoutePose> route;
  const auto go = [&](const std::string& note, const Vector3d& tip, double yaw, double pace, double dwell) {
    RoutePose pose{.note = note, .X_WT = Eigen::Isometry3d::Identity(), .travel = 0.0, .dwell = dwell};
    pose.X_WT.linear() = turn_by(yaw, Vector3d::UnitY()).toRotationMatrix();
    pose.X_WT.translation() = tip;
    if (!route.empty()) pose.travel = std::max(0.3, (tip - route.back().X_WT.translation()).norm() / pace);
    route.push_back(pose);
  };
  go("start", start, 0.0, fast, 0.5);
  for (const Stop& stop : stops) {
    const Vector3d over_it(stop.tip_W.x(), hover, stop.tip_W.z());
    go("over: " + stop.name, over_it, stop.yaw, fast, 0.0);
    go("", stop.tip_W + above * Vector3d::UnitY(), stop.yaw, fast, 0.0);
    go(stop.name, stop.tip_W - press * Vector3d::UnitY(), stop.yaw, slow, 3.6);
    route.back().presses = true;
    go("", stop.tip_W + above * Vector3d::UnitY(), stop.yaw, slow, 0.0);
    go("", over_it, stop.yaw, fast, 0.0);
  }
  return route;
}

std::string stops_yaml(const std::vector<Stop>& stops) {
  std::string text;
  for (const Stop& stop : stops) text += checkpoint_yaml(stop.name, stop.tip_W, sphere, mirrored(stop.name));
  return text;
}

}  // namespace fulcrum::content
