#include "tools/content/mesh/waypoints.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace fulcrum::content {
namespace {

std::string number(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, std::abs(value) < 5e-7 ? 0.0 : value);
  return text.data();
}

std::string list(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number("%.6f", value);
  return "[" + text + "]";
}

}  // namespace

std::string route_yaml(const std::string& how, const std::string& program,
                       const std::vector<RoutePose>& route) {
  return waypoints_yaml("The way of someone who knows how: " + how + ".", program + " --route", route);
}

std::string waypoints_yaml(const std::string& what, const std::string& command,
                           const std::vector<RoutePose>& route) {
  std::string text = "# yaml-language-server: $schema=../../schema/hand.json\nfulcrum: 1\n# " + what +
                     "\n# Written by `" + command + "`.\nwaypoints:\n";
  for (const RoutePose& pose : route) {
    if (!pose.note.empty()) text += "  # " + pose.note + "\n";
    const Eigen::Vector3d p = pose.X_WT.translation();
    const Eigen::Quaterniond q(pose.X_WT.linear());
    text += "  - position: " + list({p.x(), p.y(), p.z()}) + "\n";
    text += "    orientation: " + list({q.w(), q.x(), q.y(), q.z()}) + "\n";
    if (pose.travel > 0.0) text += "    travel: " + number("%.2f", pose.travel) + "\n";
    if (pose.dwell > 0.0) text += "    dwell: " + number("%.1f", pose.dwell) + "\n";
    if (pose.hold) text += "    hold: " + number("%.3f", *pose.hold) + "\n";
    if (pose.stop) text += "    stop: " + number("%.1f", *pose.stop) + "\n";
    if (pose.press) text += "    press: " + number("%.1f", *pose.press) + "\n";
  }
  return text;
}

std::string checkpoint_yaml(const std::string& name, const Eigen::Vector3d& p_W, double radius,
                            const std::string& mirrored_name) {
  const std::string mirrored = mirrored_name.empty() ? "" : ", mirrored_name: " + mirrored_name;
  return "  - {name: " + name + mirrored + ", position: " + list({p_W.x(), p_W.y(), p_W.z()}) +
         ", radius: " + number("%.4f", radius) + "}\n";
}

}  // namespace fulcrum::content
