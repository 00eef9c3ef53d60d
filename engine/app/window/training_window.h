#pragma once
// The window a trainee works in: the scene, the overlay, the keys, and the mouse as a device.

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/registry.h"
#include "engine/app/cli/run_options.h"
#include "engine/app/edit/scene_editor.h"
#include "engine/app/picture/bridge.h"
#include "engine/app/picture/late_tool.h"
#include "engine/app/picture/second_view.h"
#include "engine/app/run/button_commands.h"
#include "engine/app/run/run_session.h"
#include "engine/app/run/run_sink.h"
#include "engine/app/run/trial_results.h"
#include "engine/app/window/cue_switches.h"
#include "engine/app/window/eye_pointer.h"
#include "engine/app/window/frame_rate.h"
#include "engine/app/window/pad_controls.h"
#include "engine/app/window/pad_device.h"
#include "engine/app/window/review.h"
#include "engine/app/window/tick_trouble.h"
#include "engine/app/window/tool_keys.h"
#include "engine/app/window/window_sound.h"
#include "engine/app/window/window_stage.h"
#include "engine/input/pad_presses.h"
#include "engine/input/tool_mouse.h"
#include "engine/render/orbit_camera.h"
#include "engine/render/quality.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::app {

class TrainingWindow {
public:
  // All must outlive it. expert: what the trial is compared with, and shown beside; null: nothing.
  // has_start_page: F10 goes back to it. Errors: the scene cannot be drawn.
  static Result<std::unique_ptr<TrainingWindow>> create(WindowStage& stage, const Prepared& prepared,
                                                        const scenario::VisualAssembly& visual,
                                                        const RunOptions& options, const ExpertRun* expert,
                                                        bool has_start_page);

  // What the attempts from now on are compared with, beside the expert's.
  void compare_with(const std::optional<EarlierTrials>& earlier) { earlier_ = earlier; }

  // An author is at work: a save that is good ends the attempt, once the force has gone. Outlives the window.
  void edit_by(SceneEditor& editor) { editor_ = &editor; }
  // For one that follows another at the same place.
  const render::OrbitCamera& orbit() const { return camera_; }
  void look_as(const render::OrbitCamera& camera) { camera_ = camera; }
  // Of the tool when the newest attempt was left.
  const Pose& left_X_WT() const { return left_X_WT_; }

  enum class Leave { closed, restart, start_page, reload };
  // One attempt. player: of its sound; null: silence. ended: called once the trial is over, the force gone
  // and the haptic thread with it, while the window still shows what came of it; not where the window closes
  // first.
  Leave run(World& world, OpenDevice& device, RunSink& sink, const ProgramFaults& faults,
            audio::Player* player, const std::function<bool()>& ended);
  // The attempt's last moment, as it was seen, into a PNG. From ended() or after run().
  Result<std::filesystem::path> save_picture(const RunSink& sink, const std::filesystem::path& file);

  const render::RenderPlan& plan() const { return stage_.renderer().plan(); }
  // Of the attempt, until it ended.
  PictureFigures figures() const { return {frame_rate_.mean(), late_tool_.figures()}; }

private:
  TrainingWindow(WindowStage& stage, const Prepared& prepared, const scenario::VisualAssembly& visual,
                 const RunOptions& options, const ExpertRun* expert, bool has_start_page);

  // All that belonged to the attempt before is gone.
  void begin(const World& world, OpenDevice& device, const RunSink& sink);
  void listen();  // to the window's events
  void on_key(int key, int action);
  void on_press();
  // Of gamepads, whatever is the device; and where one is, what it pushes.
  void take_pads();
  void act(PadAction action);
  PadPhase pad_phase() const;
  void go_to_view(std::size_t view);
  // After the end: what a key does to the moment that is shown; false: nothing.
  bool look_back(int key);
  void scrub(bool dragged);
  void on_cursor(double x, double y);
  void on_scroll(double steps);
  // (3) m, what of the tool has to reach the checkpoints, where the mouse wants it.
  Vec3 touch_W() const;
  void send(const std::optional<Command>& command);
  void send(const std::vector<Command>& commands);
  // Whether the haptic thread has stopped the force, for the window did not answer in time; from now on it
  // has as long again.
  bool is_held_up();
  void take_stop(const RunSink& sink);  // that was made so: says it
  void restart();                       // the attempt, where that is heeded
  void note_cost(const TickEvent& event);
  // What the author's keys and pointer do; true: it is done.
  bool edit_key(int key);
  bool edit_button(int button, int action);
  SceneEditor::Seen seen_by_author() const;
  // What the panels' marks and the pointer are of.
  render::Camera seen() const { return stage_.seen(camera_.camera()); }
  static void add_edit_keys(std::vector<ui::KeyLine>& keys);
  void edit_on(LiveLoop& loop);
  // Tells a device that moves as it is seen what is seen.
  void show_to_device(const TickRecord& record);
  // After the end: the force goes as after a stop, then ticks, counters and tool rest. True: they do.
  bool come_to_rest(LiveLoop& loop);
  // Whether the tool stays where it is, whatever the mouse does: a stop is a pause.
  bool tool_rests() const { return shown_.force == ui::Force::stopped; }
  // size: of the picture.
  // Now, or at the moment that is looked back at.
  scenario::TaskState task_shown(const RunSink& sink) const;
  ui::OverlayState overlay_of(const TickRecord& record, const RunSink& sink, render::Extent size) const;
  ui::TickHealth tick_health() const;
  std::string message(const RunSink& sink) const;
  void draw(const RunSink& sink, LiveLoop& loop);
  const Afterglow& seen_afterglow(const RunSink& sink) const;
  render::FrameState frame_of(const TickRecord& record, const RunSink& sink);
  // Where the tool is touched in that tick, if that is to be shown.
  void look_for_touches(const TickRecord& record);
  // Whether the expert's tool is to be seen beside the trainee's.
  bool shows_expert() const;
  std::optional<Error> make_room_for_expert();
  void choose_second_view();

  WindowStage& stage_;
  const Prepared& prepared_;
  const scenario::VisualAssembly& visual_;

  render::AutoQuality quality_;
  render::OrbitCamera camera_;
  FrameBridge bridge_;

  // Of the attempt that runs.
  LiveLoop* loop_ = nullptr;
  const SceneDesc* scene_ = nullptr;
  MouseDevice* mouse_ = nullptr;
  RateDevice* rate_ = nullptr;
  KeyAxes* keys_ = nullptr;
  GamepadAxes* gamepad_ = nullptr;
  PadDevice pad_device_;
  input::PadPresses pad_presses_{repeating_pad_buttons()};
  bool pad_is_there_ = false;
  input::ToolMouse tool_mouse_;
  ToolKeys tool_keys_;
  ButtonCommands buttons_;            // of the device
  std::vector<std::int64_t> cpu_ns_;  // of the newest ticks, a ring
  std::size_t cpu_at_ = 0;
  std::uint64_t late_ = 0, lost_ = 0;  // ticks
  TickTrouble trouble_;
  FrameRate frame_rate_;
  LateTool late_tool_;
  bool minimised_ = false;
  // By a window that did not answer, until a picture has shown it and what was pressed before has been heard.
  bool held_up_ = false;
  bool stop_told_ = false, stop_seen_ = false;  // the stop that came of it
  bool resting_ = false;                        // the trial has ended, and the force is told to go
  bool ended_ = false;                          // ended() was called
  const RunSink* sink_ = nullptr;
  Review review_{1};                    // of the attempt that runs, to be looked back at
  std::optional<ui::Debrief> debrief_;  // once the trial has ended
  bool scrubs_ = false;                 // the left button holds the timeline

  int button_ = -1;      // that is down, or -1
  bool slides_ = false;  // it holds the slider of the holding point
  bool shift_ = false, control_ = false;
  EyePointer pointer_;
  double cursor_x_ = 0, cursor_y_ = 0;  // of the picture, in its heights
  std::size_t view_ = 0;                // that was gone to last
  bool keys_visible_ = false;
  std::size_t keys_page_ = 0;
  bool expert_shown_ = true;                // while looking back
  bool has_expert_ghost_ = false;           // the renderer has a ghost for it, the last
  std::vector<render::GhostState> ghosts_;  // of the newest frame
  bool touches_shown_ = false;
  std::optional<TouchFinder> touch_finder_;  // once they were to be shown
  std::vector<Touch> touches_;
  std::optional<ChosenView> second_view_;
  bool guides_ = true;  // the way to the next checkpoint is shown
  bool figures_visible_ = false;
  bool circle_ = false;       // of confusion: it is there
  bool circle_shown_ = true;  // where it is
  ui::OverlayState shown_;    // what the panels showed last
  CueSwitches cues_;
  DeviceWords words_;    // how the device does what hints speak of
  bool is_held_ = true;  // by a trainee, whom it pushes: it is no simulated one
  WindowSound sound_;
  const ExpertRun* expert_;
  std::optional<EarlierTrials> earlier_;
  bool has_start_page_;
  Pose left_X_WT_;
  std::string complained_;                        // of what the author saved last
  std::chrono::steady_clock::time_point looked_;  // at what the author saves
  SceneEditor* editor_ = nullptr;                 // null: nobody edits
  bool releases_ = false;                         // the force is told to go, for a scene that takes over
  bool edits_ = false;                            // the left button is the author's
  std::vector<render::MarkerState> markers_;      // of the newest frame, where one is held
  std::optional<Leave> leave_;                    // asked for by a key
  std::string error_;                             // why drawing stopped
};

}  // namespace fulcrum::app
