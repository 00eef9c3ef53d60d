#include "tools/content/tutorial/route.h"

#include <algorithm>

#include "haptics/math/rotation.h"
#include "tools/content/tutorial/blade.h"
#include "tools/content/tutorial/places.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double pace = 0.09;       // m/s, from place to place
constexpr double stay = 0.8;        // s, at a checkpoint
constexpr double over = 40.0 * mm;  // before what is touched
// The handle hangs a little, and to the right, as in a right hand; less so before the slot, which asks for
// it.
constexpr double hangs = 25.0 * degree, aside = 14.0 * degree;
constexpr double straightened = 0.25;

const Vector3d start_P(-15.0 * mm, 5.0 * mm, 120.0 * mm);

// roll: of the blade about its own axis; at 0 its width is level. leaning: the part of that hang.
Eigen::Isometry3d posed(const Vector3d& p_P, double roll, double leaning = 1.0) {
  Eigen::Isometry3d X_PM = Eigen::Isometry3d::Identity();
  X_PM.linear() = (turn_by(leaning * aside, Vector3d::UnitY()) * turn_by(leaning * hangs, Vector3d::UnitX()) *
                   turn_by(roll, Vector3d::UnitZ()))
                      .toRotationMatrix();
  X_PM.translation() = p_P;
  return panel_in_world() * X_PM;
}

constexpr double upright = 90.0 * degree, lying = 0.0;

double ridge_top(int number) {  // y in P, from the uppermost, 0
  return ridges_middle.y() + ridge_pitch * (0.5 * (ridge_count - 1) - number);
}

}  // namespace

std::vector<Lesson> make_lessons() {
  const double crest = ridges_base + ridge_height;
  return {
      {"move: the hoop", hoop_middle, 14.0 * mm},
      {"turn: the slot", slot_middle + Vector3d(0, 0, slot_depth - 15.0 * mm), 9.0 * mm},
      {"touch: the pad", pad_middle + Vector3d(0, 0, pad_height), 12.0 * mm},
      {"feel: the first ridge", {ridges_middle.x(), ridge_top(0), crest}, 10.0 * mm},
      {"feel: the last ridge", {ridges_middle.x(), ridge_top(ridge_count - 1), crest}, 10.0 * mm},
      {"stop: the button", button_middle + Vector3d(0, 0, button_height + 14.0 * mm), 16.0 * mm},
  };
}

Eigen::Isometry3d start_pose() {
  return posed(start_P, upright);
}

std::vector<RoutePose> make_route(double press) {
  const std::vector<Lesson> lessons = make_lessons();
  std::vector<RoutePose> route;
  Vector3d at = start_P;
  const auto go = [&](const std::string& note, const Vector3d& to_P, double roll, double dwell,
                      double least = 0.6, double leaning = 1.0) {
    const double travel = route.empty() ? 0.0 : std::max(least, (to_P - at).norm() / pace);
    at = to_P;
    route.push_back({.note = note, .X_WT = posed(to_P, roll, leaning), .travel = travel, .dwell = dwell});
  };
  const Vector3d out(0, 0, over);
  const Vector3d in(0, 0, -press);
  go("start", start_P, upright, 0.6);
  go(lessons[0].name, lessons[0].p_P, upright, stay);
  go("out of the hoop", lessons[0].p_P + out, upright, 0.0);
  go("before the slot", slot_middle + Vector3d(0, 0, slot_depth) + out, upright, 0.2);
  go("turned", slot_middle + Vector3d(0, 0, slot_depth) + out, lying, 0.2, 1.0, straightened);
  go(lessons[1].name, lessons[1].p_P, lying, stay, 0.6, straightened);
  go("out of the slot", slot_middle + Vector3d(0, 0, slot_depth) + out, lying, 0.0, 0.6, straightened);
  go("before the pad", lessons[2].p_P + out, lying, 0.2);
  go(lessons[2].name, lessons[2].p_P + in, lying, stay, 0.8);
  route.back().presses = true;
  go("off the pad", lessons[2].p_P + out, lying, 0.0);
  go("before the ridges", lessons[3].p_P + out, lying, 0.2);
  go(lessons[3].name, lessons[3].p_P + in, lying, stay, 0.8);
  route.back().presses = true;
  go(lessons[4].name, lessons[4].p_P + in, lying, stay, 2.4);
  route.back().presses = true;
  go("off the ridges", lessons[4].p_P + out, lying, 0.0);
  go(lessons[5].name, lessons[5].p_P, lying, 2.6);
  route.back().stop = 0.8;
  return route;
}

std::string lessons_yaml(const std::vector<Lesson>& lessons) {
  std::string text;
  for (const Lesson& lesson : lessons)
    text += checkpoint_yaml("\"" + lesson.name + "\"", panel_in_world() * lesson.p_P, lesson.radius);
  return text;
}

}  // namespace fulcrum::content
