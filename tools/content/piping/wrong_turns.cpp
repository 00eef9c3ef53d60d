#include "tools/content/piping/wrong_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "haptics/math/rotation.h"
#include "tools/content/piping/route.h"

namespace fulcrum::content {
namespace {

// A person takes their time: speeds of the mean, of T and of the turn, and the least time for a move.
constexpr double speed = 40 * mm;          // m/s
constexpr double turning = 40.0 * degree;  // rad/s
constexpr double least_travel = 0.25;      // s
constexpr double rounding = 1e-9;          // of a twentieth of a second: what is one but for it stays one
constexpr double rest = 0.5;               // s
constexpr double at_checkpoint = 3.5;      // s, a little longer than the scenario asks for

constexpr double held_wrong = 2.0;  // s
constexpr std::array between_pipes{25.0 * degree, -35.0 * degree, 15.0 * degree, -20.0 * degree};

struct Stay {
  std::string comment;
  Eigen::Isometry3d X_WT;
  double dwell;  // s
};

// About the long axis, on which the handle lies: the handle stays where it is.
Eigen::Isometry3d turned(const Eigen::Isometry3d& X_WT, double angle) {
  return X_WT * turn_by(angle, Eigen::Vector3d::UnitX());
}

std::vector<Stay> way() {
  std::vector<Stay> stays;
  for (const PlantPose& pose : route()) {
    const double dwell = pose.name.empty() ? 0.0 : pose.name == "start" ? rest : at_checkpoint;
    stays.push_back({pose.name, pose.X_WT, dwell});
    if (pose.name != "between the pipes") continue;
    stays.back().dwell = rest;
    for (const double angle : between_pipes) {
      stays.push_back({"turned wrongly", turned(pose.X_WT, angle), held_wrong});
      stays.push_back({"", pose.X_WT, rest});
    }
  }
  return stays;
}

double travel(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const double way = (to.translation() - from.translation()).norm();
  const double turn = angle_of(Eigen::Quaterniond(from.linear().transpose() * to.linear()));
  const double time = std::max({least_travel, way / speed, turn / turning});
  return std::ceil(20 * time - rounding) / 20;
}

std::string seconds(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

}  // namespace

std::string wrong_turns_yaml() {
  std::string text =
      "# yaml-language-server: $schema=../../schema/hand.json\n"
      "fulcrum: 1\n"
      "# The expert's way, but the spanner turned wrongly about its long axis while the pipes hold its ring "
      "on both\n"
      "# sides: torque that no force tells of. `make_piping --wrong-turns` wrote it.\n"
      "waypoints:\n";
  const std::vector<Stay> stays = way();
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (!stays[i].comment.empty()) text += "  # " + stays[i].comment + "\n";
    text += "  - position: " + yaml_position(stays[i].X_WT.translation()) + "\n";
    text += "    orientation: " + yaml_orientation(stays[i].X_WT.linear()) + "\n";
    if (i > 0) text += "    travel: " + seconds(travel(stays[i - 1].X_WT, stays[i].X_WT)) + "\n";
    if (stays[i].dwell > 0.0) text += "    dwell: " + seconds(stays[i].dwell) + "\n";
  }
  return text;
}

}  // namespace fulcrum::content
