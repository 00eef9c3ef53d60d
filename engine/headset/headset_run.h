#pragma once
// One attempt in a headset. The headset's runtime says when a picture is drawn; the haptic thread keeps its
// own pace.
//
// Nobody holds on to what nobody sees: where the headset shows something else, is taken off or is lost, the
// force goes and the trial rests, as after a stop, and whoever comes back goes on.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "drivers/registry.h"
#include "engine/app/picture/bridge.h"
#include "engine/app/picture/late_tool.h"
#include "engine/app/run/button_commands.h"
#include "engine/app/run/run_session.h"
#include "engine/app/window/frame_rate.h"
#include "engine/app/window/window_sound.h"
#include "engine/headset/placement.h"
#include "engine/headset/worn.h"
#include "engine/input/grasp.h"
#include "engine/render/quality.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::headset {

// Of the hands: what stands for Esc, and for Enter.
inline constexpr std::uint32_t kStopButton = 1, kHoldButton = 2;
// So many pictures in a row that show nothing are no longer a blink.
inline constexpr int kBlink = 5;

class HeadsetRun {
public:
  // All must outlive it. panel: what is said is shown there; null: nothing is.
  HeadsetRun(HeadsetStage& stage, const app::Prepared& prepared, const scenario::VisualAssembly& visual,
             const app::RunOptions& options, const app::Settings& settings, app::RunSession& attempt,
             std::unique_ptr<Panel> panel);

  // Until the trial is over, the headset's runtime ends it, or the mirror is closed.
  void run();

  // The last moment, as both eyes saw it, into a PNG.
  Result<std::filesystem::path> save_picture(const std::filesystem::path& file);
  app::PictureFigures figures() const { return {frame_rate_.mean(), late_tool_.figures()}; }

private:
  bool goes_on() const;
  void listen();              // to the mirror's keys
  void take_ticks();          // that have passed since
  void look_after_session();  // makes one where there is none, takes its events, pauses where it is not seen
  bool is_seen() const;       // the scene, by whoever wears the headset and would be heard
  void pause();
  void take_stop();     // that the haptic thread made while this one was held up
  void lose_session();  // another one is made once the headset is found again
  bool show();          // draws if it is time to; false: there is nothing to draw for
  void draw();
  void show_nothing(const xr::Frame& frame);
  void move_hands(const xr::Frame& frame);
  void come_to_rest();
  void ask_for(const std::optional<Command>& command);
  const TickRecord& shown_record();
  render::FrameState frame_of(const TickRecord& record);
  // What the panel says of it, where there is one and it is time for that.
  std::optional<Error> say(const TickRecord& record, const xr::Frame& frame);

  HeadsetStage& stage_;
  const app::Prepared& prepared_;
  const app::RunOptions& options_;
  const app::Settings& settings_;
  app::RunSession& attempt_;
  LiveLoop loop_;
  render::Camera view_;  // of the scene, that the headset's space is laid about
  Placement placement_;
  PanelPlace panel_place_;
  std::unique_ptr<Panel> panel_;  // null: nothing is said
  XrTime said_ = 0;               // ns of the runtime's clock: when the panel was written last
  app::FrameBridge bridge_;
  input::Grasp grasp_;
  app::ButtonCommands device_buttons_;
  app::ButtonCommands hand_buttons_{kStopButton, kHoldButton};
  app::WindowSound sound_;
  app::FrameRate frame_rate_;
  app::LateTool late_tool_;
  std::optional<render::AutoQuality> quality_;  // once the headset's pace is known, where it is automatic
  std::unique_ptr<Worn> worn_;                  // null: the headset is lost, or not found yet
  std::optional<std::array<render::Camera, 2>> eyes_;  // of the newest frame
  int unseen_ = kBlink;   // so many pictures in a row showed nothing; at first, none has shown anything
  bool began_ = false;    // the haptic thread
  bool paused_ = false;   // the stop that there is, is that of a headset that showed nothing
  bool held_up_ = false;  // by the headset's runtime, for too long, since ticks were taken last
  bool resting_ = false;  // the trial has ended, and the force is told to go
  bool closing_ = false;  // the headset's runtime has ended the session
  std::string error_;     // why drawing stopped
};

}  // namespace fulcrum::headset
