#pragma once
// From what ticks to what is drawn: the only place where both are seen. Eigen's types become GLM's here.

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "drivers/rate/rate_control.h"
#include "engine/app/picture/afterglow.h"
#include "engine/app/prepare/prepare.h"
#include "engine/input/tool_mouse.h"
#include "engine/render/frame_state.h"
#include "engine/scenario/device_links.h"
#include "engine/scenario/guide.h"
#include "engine/scenario/task_judge.h"
#include "engine/ui/overlay_state.h"
#include "haptics/tick/command.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

// The storage that a FrameState looks into.
class FrameBridge {
public:
  FrameBridge(const render::VisualDesc& desc, const scenario::Scenario& scenario, const SceneDesc& scene);

  // The tool as it was in that tick, the device's arms where the handle held them, the markers as the task
  // stands. The hand's ghost, if the scene has one, is put where the tool is and not where the handle is, so
  // that what is seen between the two is pure rotation, but for what the tool moves until poses() places it
  // last; the expert's, where the expert's tool would be.
  render::FrameState frame(const TickRecord& record, const Afterglow& afterglow,
                           const scenario::TaskState& task, const render::Camera& camera, double time);

  // Of what moves, as FrameState::X_WM, in that tick: valid until it is asked for another one, or for a
  // frame.
  std::span<const glm::mat4> poses(const TickRecord& record, const Afterglow& afterglow, double time);

private:
  glm::mat4 pose_of(std::size_t body, const TickRecord& record, const Afterglow& afterglow, double time);

  std::size_t markers_;
  std::size_t checkpoints_;  // the first so many of the markers
  std::optional<scenario::GuideDesc> guide_;
  Pose X_TH_;
  std::size_t left_ = 0, right_ = 0;            // channels
  double strongest_ = 0;                        // m/s^2, of their levels; 0: they are not drawn
  Quat q_WF_ = Quat::Identity();                // of the level bars
  std::optional<Quat> ghost_q_HT_;              // where the hand's ghost is shown
  bool expert_shown_ = false;                   // the expert's tool
  std::vector<render::GhostState> ghosts_;      // as VisualDesc has them: the hand's, then the expert's
  std::optional<scenario::DeviceLinks> links_;  // where something follows them
  std::vector<std::size_t> follows_;            // of each movable instance
  std::vector<glm::mat4> X_WM_;
  std::vector<render::MarkerState> marker_states_;
};

// The trainee's view of what is at p_W, and of the picture's plane there.
input::ViewAxes view_axes(const render::Camera& camera, const Vec3& p_W);
// The same for a device that moves as it is seen. rests: the tool stays where it is.
SeenFrame seen_frame(const render::Camera& camera, const Vec3& p_W, bool rests);

// N in the scene: the most that the device gives, or, where it has no motors, the coupling.
double force_limit_W(const SceneDesc& scene);

// Gauges, checkpoints and stop banner as of one tick; marks of those before it.
ui::OverlayState overlay_state(const Prepared& prepared, const SceneDesc& scene, const TickRecord& record,
                               const Afterglow& afterglow, const scenario::TaskState& task);

}  // namespace fulcrum::app
