// The way to the next checkpoint, against a pinhole camera written out here: the picture's plane at a
// distance of half its height over the tangent of half the angle of view.

#include "engine/app/picture/target_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace fulcrum::app {
namespace {

// At the height of 1 m, 2 m before the origin, level, looking along -z: right is x, up is y.
const render::Camera kCamera{{0.0F, 1.0F, 2.0F}, {0.0F, 1.0F, 0.0F}, 0.8F};
constexpr render::Extent kPicture{1000, 500};
const double kPlane = 250 / std::tan(0.4);  // px

scenario::TaskDesc task_to(const Vec3& position) {
  return {.checkpoints = {{"there", position, 0.02}},
          .dwell = 3,
          .touch_point = Vec3(0.1, 0, 0),
          .touch_name = "the tip"};
}

TickRecord touching(const Vec3& p_WC) {
  TickRecord record;
  record.X_WT.q = Quat(Eigen::AngleAxisd(std::acos(-1.0) / 2, Vec3::UnitZ()));  // 0.1 m along x: now along y
  record.X_WT.p = p_WC - Vec3(0, 0.1, 0);
  return record;
}

glm::dvec2 seen(const Vec3& p) {
  const double depth = 2 - p.z();
  return {500 + kPlane * p.x() / depth, 250 - kPlane * (p.y() - 1) / depth};
}

void expect_at(const glm::vec2& px, const glm::dvec2& expected) {
  EXPECT_NEAR(px.x, expected.x, 0.02);
  EXPECT_NEAR(px.y, expected.y, 0.02);
}

ui::TargetPlace place(const Vec3& target, const Vec3& p_WC) {
  const scenario::TaskDesc task = task_to(target);
  const auto seen = target_place(kCamera, kPicture, touching(p_WC), task, state_after(task, {}));
  EXPECT_TRUE(seen);
  return seen.value_or(ui::TargetPlace{});
}

TEST(TargetView, SeesTheTargetWhereAPinholeCameraDoes) {
  const Vec3 target(0.3, 0.8, -1), touch(-0.2, 1.1, 0.5);
  const ui::TargetPlace at = place(target, touch);
  EXPECT_TRUE(at.in_sight);
  expect_at(at.place, seen(target));
  EXPECT_NEAR(at.radius, kPlane * 0.02 / 3, 1e-3);
  EXPECT_NEAR(at.distance, std::sqrt(0.25 + 0.09 + 2.25), 1e-12);
  ASSERT_TRUE(at.touch);
  expect_at(*at.touch, seen(touch));
}

TEST(TargetView, DropsToTheTargetsHeightAndGoesOnLevel) {
  const Vec3 target(0.3, 0.8, -1), touch(-0.2, 1.1, 0.5), foot(-0.2, 0.8, 0.5);
  const ui::TargetPlace at = place(target, touch);
  ASSERT_TRUE(at.drop && at.level);
  expect_at(at.drop->from, seen(touch));
  expect_at(at.drop->to, seen(foot));
  expect_at(at.level->from, seen(foot));
  expect_at(at.level->to, seen(target));
}

// To the right of the picture and a little up: the line from its middle leaves it at its right edge.
TEST(TargetView, OutOfSightItPointsFromTheEdge) {
  const Vec3 target(5, 1.5, 0);
  const ui::TargetPlace at = place(target, Vec3::Zero());
  EXPECT_FALSE(at.in_sight);
  EXPECT_EQ(at.radius, 0.0F);
  const double length = std::hypot(5, 0.5);
  expect_at(at.way, {5 / length, -0.5 / length});
  expect_at(at.place, {1000, 250 - 500 * 0.1});
  const ui::TargetPlace above = place({0, 9, 0}, Vec3::Zero());
  expect_at(above.way, {0, -1});
  expect_at(above.place, {500, 0});
}

// Behind the camera, to its right: a person would turn right.
TEST(TargetView, BehindTheCameraItPointsToItsSide) {
  const ui::TargetPlace at = place({1, 1, 4}, {0, 1, 0});
  EXPECT_FALSE(at.in_sight);
  expect_at(at.way, {1, 0});
  expect_at(at.place, {1000, 250});
  // Straight behind: any side is as good, and nothing is divided by nothing.
  const ui::TargetPlace straight = place({0, 1, 4}, {0, 1, 0});
  expect_at(straight.way, {0, 1});
  expect_at(straight.place, {500, 500});
}

TEST(TargetView, LinesEndBeforeTheCamera) {
  // From far before the camera to behind it: what is seen lies on the line's picture.
  const Vec3 touch(0.4, 1.2, 0), target(0.4, 1, 6);
  const ui::TargetPlace at = place(target, touch);
  ASSERT_TRUE(at.drop && at.level);
  expect_at(at.level->from, seen({0.4, 1, 0}));
  // 5 mm before the eye.
  const Vec3 nearest(0.4, 1, 2 - 0.005);
  EXPECT_NEAR(at.level->to.x, seen(nearest).x, 20);
  EXPECT_NEAR(at.level->to.y, 250, 0.1);
  const ui::TargetPlace behind = place(target, {0.4, 1.2, 5});
  EXPECT_FALSE(behind.drop || behind.level || behind.touch);
}

// How deep it lies is told against the picture's plane, in m and in what a drag is long at the touch point's
// depth.
TEST(TargetView, TellsHowMuchFartherOrNearerTheTargetIs) {
  const Vec3 touch(-0.2, 1.1, 0.5);  // 1.5 m before the eye
  const ui::TargetPlace behind = place({0.3, 0.8, -1}, touch);
  ASSERT_TRUE(behind.farther);
  EXPECT_NEAR(behind.farther->depth, 1.5, 1e-6);
  EXPECT_NEAR(behind.farther->drag, kPlane, 1e-2);
  const ui::TargetPlace before = place({0.3, 0.8, 0.8}, touch);
  ASSERT_TRUE(before.farther);
  EXPECT_NEAR(before.farther->depth, -0.3, 1e-6);
  EXPECT_NEAR(before.farther->drag, kPlane * -0.3 / 1.5, 1e-2);
  // Half of its radius, 20 mm, is as deep.
  EXPECT_FALSE(place({0.3, 0.8, 0.491}, touch).farther);
  EXPECT_TRUE(place({0.3, 0.8, 0.489}, touch).farther);
  EXPECT_FALSE(place({0.3, 0.8, 3}, touch).farther);  // behind the camera
}

TEST(TargetView, ShowsTheCheckpointThatIsNextAndNoneAfterTheLast) {
  scenario::TaskDesc task = task_to({0.3, 0.8, -1});
  task.checkpoints.push_back({"then", Vec3(-0.3, 0.8, -1), 0.02});
  scenario::TaskState state = state_after(task, {1.0, {}});
  state.inside = true;
  state.dwell_progress = 0.25;
  const auto then = target_view(kCamera, kPicture, touching(Vec3::Zero()), task, state);
  ASSERT_TRUE(then);
  EXPECT_EQ(then->name, "then");
  EXPECT_TRUE(then->dwelling);
  EXPECT_EQ(then->progress, 0.25F);
  EXPECT_EQ(then->dwell_s, 3.0);
  expect_at(then->at.place, seen({-0.3, 0.8, -1}));
  EXPECT_FALSE(target_view(kCamera, kPicture, touching(Vec3::Zero()), task, state_after(task, {1.0, 2.0})));
  EXPECT_FALSE(target_view(kCamera, kPicture, touching(Vec3::Zero()), {}, {}));
}

TEST(TargetView, NamesTheTouchPointAtTheBeginning) {
  scenario::TaskDesc task = task_to({0.3, 0.8, -1});
  scenario::TaskState state = state_after(task, {{}});
  const auto name = [&] {
    return target_view(kCamera, kPicture, touching(Vec3::Zero()), task, state)->touch_name;
  };
  EXPECT_EQ(name(), "the tip");
  task.touch_name.clear();
  EXPECT_EQ(name(), "the touch point");
  state.inside = true;
  EXPECT_EQ(name(), "");
  state.inside = false;
  state.time = 60;
  EXPECT_EQ(name(), "");
}

TEST(TargetView, PointsToAToolThatIsOutOfThePicture) {
  const scenario::TaskDesc task = task_to(Vec3::Zero());
  EXPECT_FALSE(lost_tool(kCamera, kPicture, touching({0.2, 1.1, 0}), task)) << "it is in it";
  const auto right = lost_tool(kCamera, kPicture, touching({5, 1.5, 0}), task);
  ASSERT_TRUE(right);
  const double length = std::hypot(5, 0.5);
  expect_at(right->way, {5 / length, -0.5 / length});
  expect_at(right->place, {1000, 250 - 500 * 0.1});
  EXPECT_EQ(right->name, "the tip");
  const auto behind = lost_tool(kCamera, kPicture, touching({-1, 1, 4}), {});
  ASSERT_TRUE(behind);
  EXPECT_LT(behind->way.x, -0.9F);
  EXPECT_EQ(behind->name, "the tool");
  EXPECT_FALSE(lost_tool(kCamera, kPicture, touching(Vec3::Constant(std::nan(""))), task));
}

TEST(TargetView, AToolThatIsNowhereHasNoWay) {
  const TickRecord lost = touching(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  const scenario::TaskDesc task = task_to({0.3, 0.8, -1});
  EXPECT_FALSE(target_view(kCamera, kPicture, lost, task, state_after(task, {{}})));
}

TEST(TargetView, SaysWhatIsLackingThere) {
  scenario::TaskDesc task = task_to({0.3, 0.8, -1});
  scenario::TaskState state = state_after(task, {{}});
  state.inside = true;
  const auto name = [&](scenario::Lack lack) {
    state.lack = lack;
    return target_view(kCamera, kPicture, touching({0.3, 0.8, -1}), task, state).value_or(ui::Target{}).name;
  };
  EXPECT_EQ(name(scenario::Lack::touch), "touch it");
  EXPECT_EQ(name(scenario::Lack::stop), "stop the force here");
  EXPECT_EQ(name(scenario::Lack::more_force), "press harder");
  EXPECT_EQ(name(scenario::Lack::less_force), "press less hard");
  EXPECT_EQ(name(scenario::Lack::facing), "turn the tool");
  EXPECT_EQ(name(scenario::Lack::less_depth), "too deep");
  EXPECT_EQ(name(scenario::Lack::nothing), "there");
}

TEST(Advice, IsTheHintOfTheNextCheckpointAsTheDeviceDoesIt) {
  scenario::TaskDesc task = task_to(Vec3::Zero());
  task.checkpoints[0].hint = "Go there: {move}. Then {stop}.";
  task.checkpoints.push_back({"on", Vec3(0, 0, 0), 0.02});
  const auto said = [&](std::size_t step, const char* device) {
    std::vector<std::optional<double>> reached(task.checkpoints.size());
    std::fill_n(reached.begin(), step, 1.0);
    return advice(task, state_after(task, std::move(reached)), device_words(device));
  };
  EXPECT_EQ(said(0, "spacemouse"), "Go there: push the cap. Then press Esc.");
  EXPECT_EQ(said(0, "dualsense+dualsense_coils"),
            "Go there: left stick, and R2 and L2 away and nearer. Then press Share.");
  EXPECT_EQ(said(0, "simulated:w6d"), "Go there: move the handle. Then press Esc.");
  EXPECT_EQ(said(1, "mouse"), "");  // it has none
  EXPECT_EQ(said(2, "mouse"), "");  // all are reached
}

}  // namespace
}  // namespace fulcrum::app
