#pragma once
// The window a trainee works in: the scene, the overlay, the keys, and the mouse as a device.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/registry.h"
#include "engine/app/cli/run_options.h"
#include "engine/app/picture/bridge.h"
#include "engine/app/run/run_sink.h"
#include "engine/app/window/cue_switches.h"
#include "engine/app/window/frame_rate.h"
#include "engine/app/window/review.h"
#include "engine/app/window/tick_trouble.h"
#include "engine/app/window/tool_keys.h"
#include "engine/app/window/window_stage.h"
#include "engine/input/tool_mouse.h"
#include "engine/render/orbit_camera.h"
#include "engine/render/quality.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::app {

class TrainingWindow {
public:
  // All must outlive it. expert: what the trial is compared with at its end; null: nothing. has_start_page:
  // F10 goes back to it. Errors: the scene cannot be drawn.
  static Result<std::unique_ptr<TrainingWindow>> create(WindowStage& stage, const Prepared& prepared,
                                                        const scenario::VisualAssembly& visual,
                                                        const RunOptions& options,
                                                        const session::TrialMetrics* expert,
                                                        bool has_start_page);

  enum class Leave { closed, restart, start_page };
  // One attempt.
  Leave run(World& world, OpenDevice& device, RunSink& sink, const ProgramFaults& faults);
  // The attempt's last moment, as it was seen, into a PNG. After run().
  Result<std::filesystem::path> save_picture(const RunSink& sink, const std::filesystem::path& file);

  const render::RenderPlan& plan() const { return stage_.renderer().plan(); }
  double frames_per_s() const { return frame_rate_.mean(); }  // of the attempt, until it ended

private:
  TrainingWindow(WindowStage& stage, const Prepared& prepared, const scenario::VisualAssembly& visual,
                 const session::TrialMetrics* expert, bool has_start_page);

  // All that belonged to the attempt before is gone.
  void begin(const World& world, OpenDevice& device, const RunSink& sink);
  void listen();  // to the window's events
  void on_key(int key, int action);
  // Of the device, that are down.
  void on_buttons(std::uint32_t down);
  void on_press();
  // After the end: what a key does to the moment that is shown; false: nothing.
  bool look_back(int key);
  void scrub(bool dragged);
  void on_cursor(double x, double y);
  void on_scroll(double steps);
  void send(const std::optional<Command>& command);
  void send(const std::vector<Command>& commands);
  void note_cost(const TickEvent& event);
  // Tells a device that moves as it is seen what is seen.
  void show_to_device(const TickRecord& record);
  // After the end: the force goes as after a stop, then ticks, counters and tool rest.
  void come_to_rest(LiveLoop& loop);
  // Whether the tool stays where it is, whatever the mouse does: a stop is a pause.
  bool tool_rests() const { return shown_.force == ui::Force::stopped; }
  // size: of the picture.
  // Now, or at the moment that is looked back at.
  scenario::TaskState task_shown(const RunSink& sink) const;
  ui::OverlayState overlay_of(const TickRecord& record, const RunSink& sink, render::Extent size) const;
  ui::TickHealth tick_health() const;
  std::string message(const RunSink& sink) const;
  void draw(const RunSink& sink, LiveLoop& loop);
  render::FrameState frame_of(const TickRecord& record, const RunSink& sink);

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
  input::ToolMouse tool_mouse_;
  ToolKeys tool_keys_;
  std::uint32_t stop_buttons_ = 0, go_buttons_ = 0, buttons_ = 0;  // of the device
  std::vector<std::int64_t> cpu_ns_;                               // of the newest ticks, a ring
  std::size_t cpu_at_ = 0;
  std::uint64_t late_ = 0, lost_ = 0;  // ticks
  TickTrouble trouble_;
  FrameRate frame_rate_;
  bool resting_ = false;
  const RunSink* sink_ = nullptr;
  Review review_{1};                    // of the attempt that runs, to be looked back at
  std::optional<ui::Debrief> debrief_;  // once the trial has ended
  bool scrubs_ = false;                 // the left button holds the timeline

  int button_ = -1;      // that is down, or -1
  bool slides_ = false;  // it holds the slider of the holding point
  bool shift_ = false, control_ = false;
  double cursor_x_ = 0, cursor_y_ = 0;
  std::size_t view_ = 0;  // that was gone to last
  bool keys_visible_ = false;
  bool guides_ = true;  // the way to the next checkpoint is shown
  bool figures_visible_ = false;
  bool circle_ = false;       // of confusion: it is there
  bool circle_shown_ = true;  // where it is
  ui::OverlayState shown_;    // what the panels showed last
  CueSwitches cues_;
  const session::TrialMetrics* expert_;
  bool has_start_page_;
  std::optional<Leave> leave_;  // asked for by a key
  std::string error_;           // why drawing stopped
};

}  // namespace fulcrum::app
