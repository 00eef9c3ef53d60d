#include "engine/scenario/advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "engine/scenario/task_judge.h"
#include "haptics/bake/overlap_depth.h"
#include "haptics/bake/triangle_distance.h"
#include "haptics/device/hand.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"

namespace fulcrum::scenario {
namespace {

// m. What lies less deep is clear: the last digits of a scenario's own numbers are worth that much.
constexpr double kClear = 2e-5;
// m. A response pushes a tool out that starts less deep.
constexpr double kPushedOut = 5e-4;
// Distances to one solid that one pose may cost.
constexpr std::int64_t kDistancesAPose = 5'000;
constexpr int kRandomTurns = 24;  // of the tool, at each checkpoint, beside those that its hands take

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", metres * 1e3);
  return text;
}

// (3) m, in W: where the touch point is once the checkpoint's way is done.
Vec3 end_of(const Checkpoint& checkpoint) {
  if (checkpoint.insert)
    return checkpoint.position + checkpoint.insert->depth * checkpoint.insert->direction_W;
  return checkpoint.follow.empty() ? checkpoint.position : checkpoint.follow.back();
}

std::string place_text(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "[%.4g, %.4g, %.4g]", p.x(), p.y(), p.z());
  return text;
}

// Uniform: the normal distribution of four axes favours none.
Quat random_turn(SplitMix& random) {
  std::array<double, 4> q{};
  for (double& each : q) each = random.normal();
  return Quat(q[0], q[1], q[2], q[3]).normalized();
}

class Adviser {
public:
  explicit Adviser(const HapticAssembly& assembly)
      : assembly_(assembly),
        overlap_(assembly.scene_W, assembly.tool_T, assembly.scene.scene_field.get()),
        to_scene_(assembly.scene_W),
        solid_touch_point_(touch_point_is_solid()) {}

  std::vector<Advice> take() {
    look_at_start();
    for (std::size_t i = 0; i < assembly_.task.checkpoints.size(); ++i) look_at_checkpoint(i);
    for (const HandScript& hand : assembly_.hands) look_at_path(hand);
    return std::move(found_);
  }

private:
  DeepestOverlap overlap_at(const Pose& X_WT) const {
    return overlap_.at(X_WT, {.above = kClear, .tolerance = kClear, .distances = kDistancesAPose});
  }

  void look_at_start() {
    const DeepestOverlap overlap = overlap_at(assembly_.scene.tool.X_WT_start);
    if (overlap.depth <= kClear) return;
    found_.push_back({"tool.start",
                      "puts the tool " + millimetres(overlap.depth) + " deep into the scene, at " +
                          place_text(overlap.p_W) + ": move it out, so that a run begins in the open",
                      overlap.depth > kPushedOut ? Severity::error : Severity::warning});
  }

  // The tool with its touch point at p_W.
  Pose with_touch_point_at(const Vec3& p_W, const Quat& q_WT) const {
    return {q_WT, p_W - q_WT * assembly_.task.touch_point};
  }

  // How the tool may be turned at a place of a checkpoint: as that asks, or as hands come by, as it starts,
  // and at random.
  std::vector<Quat> turns(const Checkpoint& checkpoint, const Vec3& place_W) const {
    std::vector<Quat> turns;
    if (checkpoint.facing) {
      SplitMix near(2);
      turns.push_back(checkpoint.facing->q_WT);
      for (int i = 0; i < kRandomTurns; ++i) {
        const Vec3 axis = random_turn(near).vec().normalized();
        turns.push_back(turn_by(near.uniform() * checkpoint.facing->within, axis) * checkpoint.facing->q_WT);
      }
      return turns;
    }
    for (const HandScript& hand : assembly_.hands)
      for (const Waypoint& waypoint : hand.waypoints)
        if ((waypoint.X_WT * assembly_.task.touch_point - place_W).norm() <= checkpoint.radius)
          turns.push_back(waypoint.X_WT.q);
    turns.push_back(assembly_.scene.tool.X_WT_start.q);
    SplitMix random(1);
    for (int i = 0; i < kRandomTurns; ++i) turns.push_back(random_turn(random));
    return turns;
  }

  // The touch point is of the tool's own surface or inside it, so that nothing of the scene can be there.
  bool touch_point_is_solid() const {
    return TriangleDistance(assembly_.tool_T).signed_distance(assembly_.task.touch_point) <= kClear;
  }

  // m, by how far the handle is then out of the device's workspace, of which no clutch brings it back.
  double beyond_reach(const Pose& X_WT) const {
    const SceneDesc& scene = assembly_.scene;
    if (scene.mapping.clutch_button >= 0 || scene.mapping.drift > 0) return 0;
    const Pose X_DH = scene.mapping.handle_in_device(X_WT * scene.tool.X_HT.inverse());
    const Vec3 from_centre = (X_DH.p - scene.device.workspace_centre).cwiseAbs();
    return (from_centre - scene.device.workspace).cwiseMax(0.0).norm();
  }

  void look_at_checkpoint(std::size_t index) {
    const Checkpoint& checkpoint = assembly_.task.checkpoints[index];
    const std::string key = "checkpoints." + std::to_string(checkpoint.written);
    look_at_place(checkpoint, checkpoint.position, key + ".position");
    for (std::size_t i = 0; i < checkpoint.follow.size(); ++i)
      look_at_place(checkpoint, checkpoint.follow[i], key + ".follow." + std::to_string(i) + ".corner");
    if (checkpoint.insert) look_at_place(checkpoint, end_of(checkpoint), key + ".insert.depth");
  }

  void look_at_place(const Checkpoint& checkpoint, const Vec3& place_W, const std::string& key) {
    const double depth = -to_scene_.signed_distance(place_W);
    if (solid_touch_point_ && depth > checkpoint.radius + kClear) {
      found_.push_back({key,
                        "lies " + millimetres(depth) + " deep in the scene and counts within " +
                            millimetres(checkpoint.radius) +
                            " of it, where the tool's touch point cannot come: move it out, or widen its "
                            "'radius'",
                        Severity::error});
      return;
    }
    // The middle, and most of the way to the border along the axes.
    std::array<Vec3, 7> places;
    places.fill(place_W);
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side)
        places[static_cast<std::size_t>(1 + 2 * axis + side)][axis] +=
            (side ? -0.9 : 0.9) * checkpoint.radius;
    const double clear = std::min(kPushedOut, 0.5 * checkpoint.radius);
    int tried = 0;
    double beyond = std::numeric_limits<double>::infinity();  // of poses in which the tool is clear
    for (const Quat& turn : turns(checkpoint, place_W)) {
      for (const Vec3& place : places) {
        ++tried;
        const Pose X_WT = with_touch_point_at(place, turn);
        if (overlap_at(X_WT).depth > clear) continue;
        beyond = std::min(beyond, beyond_reach(X_WT));
        if (beyond <= 0) return;
      }
    }
    const std::string as_far = ", as far as " + std::to_string(tried) + " poses of the tool tell";
    if (std::isfinite(beyond))
      found_.push_back({key,
                        "takes the handle " + millimetres(beyond) + " out of the workspace of the device '" +
                            assembly_.scene.device.name + "'" + as_far +
                            ": see 'base' and 'position_scale' of 'device'",
                        Severity::warning});
    else
      found_.push_back({key,
                        "cannot be reached" + as_far +
                            ": with its touch point there, some of it is inside the scene; move the "
                            "checkpoint, widen its 'radius', or see whether 'touch_point' is right",
                        Severity::warning});
  }

  // The hand's path as it is meant, by the task's own judge: what comes after the end is never played.
  void look_at_path(const HandScript& hand) {
    TaskDesc task = assembly_.task;
    for (Checkpoint& checkpoint : task.checkpoints) {
      checkpoint.needs = Needs::place;
      checkpoint.force.reset();
    }
    task.hard_touch.reset();
    const double tick_s = assembly_.scene.tick_s;
    TaskJudge judge(task, tick_s);
    const HandPath path(hand.waypoints);
    TickRecord record;
    for (record.tick = 0; static_cast<double>(record.tick) * tick_s < path.duration(); ++record.tick) {
      record.X_WT = path.at(static_cast<double>(record.tick) * tick_s);
      judge.judge(record);
      if (judge.state().completed) break;
    }
    if (!judge.state().completed) return;
    const auto index =
        std::ranges::find(judge.state().reached, judge.completion_time()) - judge.state().reached.begin();
    const Checkpoint& last = task.checkpoints[static_cast<std::size_t>(index)];
    const auto is_there = [&](const Waypoint& waypoint) {
      return (waypoint.X_WT * task.touch_point - end_of(last)).norm() <= last.radius;
    };
    const auto there = std::find_if(hand.waypoints.rbegin(), hand.waypoints.rend(), is_there);
    const auto after = there == hand.waypoints.rend() ? 0 : there - hand.waypoints.rbegin();
    if (after == 0) return;
    found_.push_back({"hands." + hand.name + ".path",
                      "goes on after the last checkpoint, where a run ends: the last " +
                          (after == 1 ? "waypoint is" : std::to_string(after) + " waypoints are") +
                          " never played",
                      Severity::note});
  }

  const HapticAssembly& assembly_;
  OverlapDepth overlap_;
  TriangleDistance to_scene_;
  bool solid_touch_point_;
  std::vector<Advice> found_;
};

}  // namespace

std::vector<Advice> advise(const HapticAssembly& assembly) {
  return Adviser(assembly).take();
}

}  // namespace fulcrum::scenario
