#include "engine/app/picture/bridge.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/app/picture/holding_controls.h"
#include "engine/scenario/followed.h"
#include "engine/scenario/level_bars.h"
#include "engine/scenario/to_glm.h"
#include "haptics/effects/effects.h"
#include "haptics/math/functions.h"
#include "haptics/safety/faults.h"
#include "haptics/safety/guard.h"

namespace fulcrum::app {
namespace {

Vec3 to_eigen(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

render::MarkerState marker_state(const scenario::TaskState& task, std::size_t i) {
  using Show = render::MarkerState::Show;
  if (i >= task.reached.size()) return {Show::hidden, 0.0F};  // nobody judges this task
  if (task.reached[i]) return {Show::done, 1.0F};
  if (!task.open[i]) return {Show::hidden, 0.0F};
  if (i != task.step) return {Show::next, 0.0F};
  render::MarkerState state{task.inside ? Show::dwelling : Show::next,
                            static_cast<float>(scenario::shown_progress(task))};
  state.position = scenario::narrowed(task.place_W);
  return state;
}

// What the task counts, of what should not be.
std::vector<ui::CountLine> counted_faults(const scenario::TaskDesc& task, const scenario::TaskState& state) {
  std::vector<ui::CountLine> faults;
  if (task.hard_touch) faults.push_back({"Hard touches", state.hard_touches});
  if (has_ways(task)) faults.push_back({"Slips", state.slips});
  if (!task.avoid.empty()) faults.push_back({"Trespasses", state.trespasses});
  return faults;
}

// s; 0: they differ.
double common_dwell(const scenario::TaskDesc& task) {
  const double first = dwell_of(task, task.checkpoints.front());
  const bool same = std::ranges::all_of(task.checkpoints, [&](const scenario::Checkpoint& checkpoint) {
    return dwell_of(task, checkpoint) == first;
  });
  return same ? first : 0;
}

std::vector<ui::CueLine> cue_lines(const SceneDesc& scene, const TickRecord& record,
                                   const Afterglow& afterglow) {
  std::vector<ui::CueLine> lines;
  for (const Knob& knob : effect_knobs(scene, scene, record)) {
    std::string effect = knob.effect;
    effect.front() = static_cast<char>(effect.front() - 'a' + 'A');
    lines.push_back({std::move(effect), knob.name, std::string(1, knob.key), knob.gain,
                     knob.brief ? afterglow.peak(knob.kind) : knob.level});
  }
  return lines;
}

std::vector<ui::MotorBar> motor_bars(const MechanismDesc& mechanism, const TickRecord& record,
                                     const Afterglow& afterglow) {
  std::vector<ui::MotorBar> bars;
  for (int motor = 0; motor < Mechanism::motors(mechanism); ++motor) {
    const auto i = static_cast<std::size_t>(motor);
    std::string name = Mechanism::motor_name(mechanism, motor);
    std::ranges::replace(name, '_', ' ');
    bars.push_back(
        {std::move(name), record.actuator_load[i], afterglow.motors()[i].low, afterglow.motors()[i].high});
  }
  return bars;
}

std::string stop_reason(std::uint32_t faults) {
  if ((faults & kStoppingFaults) == kStopRequested)
    return "you asked for it. The force is off, and time rests.";
  for (const FaultName& fault : fault_names())
    if ((fault.bit & kStoppingFaults & faults) != 0) return fault.sentence;
  return {};
}

}  // namespace

FrameBridge::FrameBridge(const render::VisualDesc& desc, const scenario::Scenario& scenario,
                         const SceneDesc& scene)
    : markers_(desc.markers.size()),
      checkpoints_(scenario.checkpoints.size()),
      guide_(scenario.guide),
      X_TH_(scene.tool.X_HT.inverse()) {
  // A picture of the scene alone has none.
  if (shows_ghost(scene, scene) && !desc.ghosts.empty()) ghost_q_HT_ = scene.tool.X_HT.q;
  expert_shown_ = follows_expert(scene) && !desc.ghosts.empty();
  if (const auto use = channel_use(scene, scene); use && use->axis_W) {
    left_ = scene.device.vibrotactile->find("left").value_or(0);
    right_ = scene.device.vibrotactile->find("right").value_or(0);
    strongest_ = use->signal.largest;
    q_WF_ = scenario::level_turn(*use->axis_W);
  }
  for (const render::Instance& instance : desc.instances) {
    if (!instance.movable) continue;
    follows_.push_back(instance.follows);
    X_WM_.push_back(instance.X_WM);
    if (instance.follows > 0 && instance.follows < scenario::kFirstFollowed && !links_)
      links_.emplace(scene.device.mechanism, scene.mapping);
  }
  marker_states_.resize(markers_);
}

// All but the device's links.
glm::mat4 FrameBridge::pose_of(std::size_t body, const TickRecord& record, const Afterglow& afterglow,
                               double time) {
  if (body >= scenario::kFollowsImpactCircle)
    return impact_circle_pose(body, afterglow.struck(), record.X_WT, time);
  const Pose X_WH = record.X_WT * X_TH_;  // where the tool is seen to be held
  const Pose X_WF{q_WF_, X_WH.p};         // of the level bars
  const auto level_at = [&](int side, std::size_t channel) {
    const VibrotactileCommand* told = channel_command(record);
    return scenario::level_pose(X_WF, side, told ? told->level[channel] / strongest_ : 0);
  };
  switch (body) {
    case scenario::kFollowsGuide:
      return scenario::to_glm({Quat::Identity(), scenario::guide_place(*guide_, time)});
    case scenario::kFollowsHoldingPoint:
      return scenario::to_glm({X_WH.q, X_WH * record.holding.value_or(HoldingRecord()).p_HG});
    case scenario::kFollowsLevelFrame:
      return scenario::to_glm(X_WF);
    case scenario::kFollowsLeftLevel:
      return level_at(-1, left_);
    case scenario::kFollowsRightLevel:
      return level_at(1, right_);
    default:
      return scenario::to_glm(record.X_WT);
  }
}

std::span<const glm::mat4> FrameBridge::poses(const TickRecord& record, const Afterglow& afterglow,
                                              double time) {
  const std::vector<Pose>* X_WL = links_ ? &links_->follow(record.X_WH) : nullptr;
  for (std::size_t i = 0; i < X_WM_.size(); ++i) {
    const std::size_t body = follows_[i];
    const bool link = body > 0 && body < scenario::kFirstFollowed;
    X_WM_[i] = link ? scenario::to_glm((*X_WL)[body - 1]) : pose_of(body, record, afterglow, time);
  }
  return X_WM_;
}

render::FrameState FrameBridge::frame(const TickRecord& record, const Afterglow& afterglow,
                                      const scenario::TaskState& task, const render::Camera& camera,
                                      double time) {
  // After the checkpoints come the places to avoid.
  for (std::size_t i = 0; i < markers_; ++i)
    marker_states_[i] = i < checkpoints_ ? marker_state(task, i)
                                         : render::MarkerState{render::MarkerState::Show::avoid, 0.0F};
  render::FrameState state;
  state.X_WM = poses(record, afterglow, time);
  state.markers = marker_states_;
  ghosts_.clear();
  if (ghost_q_HT_)
    ghosts_.push_back({static_cast<float>(ghost_opacity(record)),
                       scenario::to_glm({record.X_WH.q * *ghost_q_HT_, record.X_WT.p})});
  if (expert_shown_) {
    const ExpertAhead expert = expert_ahead(record).value_or(ExpertAhead());
    ghosts_.push_back({static_cast<float>(expert.opacity), scenario::to_glm(expert.X_WT)});
  }
  state.ghosts = ghosts_;
  state.camera = camera;
  state.time_s = time;
  return state;
}

input::ViewAxes view_axes(const render::Camera& camera, const Vec3& p_W) {
  const Vec3 eye = to_eigen(camera.eye);
  input::ViewAxes axes;
  axes.forward_W = (to_eigen(camera.target) - eye).normalized();
  axes.right_W = axes.forward_W.cross(Vec3::UnitY()).normalized();
  axes.up_W = axes.right_W.cross(axes.forward_W);
  // What is nearer than that is moved as if it were there, and straight ahead.
  constexpr double nearest = 5e-3;  // m
  const double depth = (p_W - eye).dot(axes.forward_W);
  const double distance = std::max(depth, nearest);
  axes.sight_W = depth > nearest ? Vec3((p_W - eye) / depth) : axes.forward_W;
  axes.height = 2 * distance * math::tan(0.5 * static_cast<double>(camera.vertical_fov_rad));
  return axes;
}

SeenFrame seen_frame(const render::Camera& camera, const Vec3& p_W, bool rests) {
  const input::ViewAxes axes = view_axes(camera, p_W);
  Mat3 R_WV;
  R_WV << axes.right_W, axes.up_W, -axes.forward_W;
  return {Quat(R_WV), axes.height, rests};
}

double force_limit_W(const SceneDesc& scene) {
  return scene.device.renders_force ? scene.device.max_force / scene.mapping.force_scale
                                    : scene.coupling.max_force;
}

ui::OverlayState overlay_state(const Prepared& prepared, const SceneDesc& scene, const TickRecord& record,
                               const Afterglow& afterglow, const scenario::TaskState& task) {
  ui::OverlayState state;
  state.time_s = static_cast<double>(record.tick) * scene.tick_s;
  state.scenario = prepared.scenario.title;
  state.device = device_on_screen(prepared, scene);
  if (scene.device.renders_force) {
    state.force_N = {record.device_F_H_D.force.norm(), scene.device.max_force};
  } else {
    // No motors: what the hand would feel, so that a push can be seen.
    state.force_N = {record.force_gain * record.coupling_F_T_W.force.norm(), scene.coupling.max_force};
  }
  state.torque_Nm = {record.force_gain * record.coupling_F_T_W.torque.norm(), scene.coupling.max_torque};
  for (std::size_t i = 0; i < prepared.haptic.task.checkpoints.size(); ++i)
    state.checkpoints.push_back({prepared.haptic.task.checkpoints[i].name, marker_state(task, i)});
  if (!state.checkpoints.empty())
    state.trial = {task.time, prepared.scenario.time_limit, common_dwell(prepared.haptic.task)};
  state.cues = cue_lines(scene, record, afterglow);
  const std::optional<TorqueNote> torque = torque_note(scene, scene, record);
  state.tells_torque = torque.has_value();
  if (torque) {
    state.variant = torque->variant;
    state.torque_bad = torque->bad;
  }
  if (scenario::draws_arms(prepared.scenario, scene))
    state.motors = motor_bars(scene.device.mechanism, record, afterglow);
  state.holding = holding_panel(scene, record);
  state.faults = counted_faults(prepared.haptic.task, task);
  if (record.stopped)
    state.force = ui::Force::stopped;
  else if (record.force_gain < 1 && state.time_s > kRampIn)  // it was never away when all begins
    state.force = ui::Force::returning;
  state.stop_reason = stop_reason(record.faults);
  return state;
}

}  // namespace fulcrum::app
