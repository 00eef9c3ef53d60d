#pragma once
// One attempt in a headset. The headset's runtime says when a picture is drawn; the haptic thread keeps its
// own pace.
//
// Nobody holds on to what nobody sees: where the headset shows something else, is taken off or is lost, the
// force goes and the trial rests, as after a stop, and whoever comes back goes on.

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "drivers/registry.h"
#include "engine/app/run/button_commands.h"
#include "engine/app/run/debrief.h"
#include "engine/app/run/run_session.h"
#include "engine/app/window/window_sound.h"
#include "engine/headset/colocated.h"
#include "engine/headset/placement.h"
#include "engine/headset/scene_pictures.h"
#include "engine/headset/tool_in_hands.h"
#include "engine/headset/worn.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::headset {

// So many pictures in a row that show nothing are no longer a blink.
inline constexpr int kBlink = 5;

class HeadsetRun {
public:
  // All must outlive it. panel: what is said is shown there; null: nothing is. colocated: the device is seen
  // where it is felt; null: the scene is before who wears the headset. with: what the trial is compared with.
  HeadsetRun(HeadsetStage& stage, const app::Prepared& prepared, const scenario::VisualAssembly& visual,
             const app::RunOptions& options, const app::Settings& settings, app::RunSession& attempt,
             std::unique_ptr<Panel> panel, std::unique_ptr<Colocated> colocated, const app::Comparison& with);

  // Until the trial is over, the headset's runtime ends it, or the mirror is closed. ended: called once when
  // the trial is over and the force has gone, for what may not be lost while somebody still looks at what
  // came of it.
  void run(std::function<void()> ended);

  // The last moment, as both eyes saw it, into a PNG.
  Result<std::filesystem::path> save_picture(const std::filesystem::path& file) {
    return pictures_.save(file);
  }
  app::PictureFigures figures() const;

private:
  bool goes_on() const;
  void listen();              // to the mirror's keys
  void hear_mirror();         // its events
  void take_ticks();          // that have passed since
  void look_after_session();  // makes one where there is none, takes its events, pauses where it is not seen
  bool is_seen() const;       // the scene, by whoever wears the headset and would be heard
  void pause(const char* why);
  // That the haptic thread made while this one was held up by what was silent.
  void take_stop(const char* silent = "the headset's runtime");
  void lose_session();  // another one is made once the headset is found again
  bool show();          // draws if it is time to; false: there is nothing to draw for
  bool draw();          // true: the headset shows a new picture
  void show_in_mirror();
  void keep_pace();  // chooses the next picture's quality, so that the headset's pace is kept
  void show_nothing(const xr::Frame& frame);
  void place();  // the scene, where the device is seen where it is felt
  void follow_space(const xr::Frame& frame);
  void move_hands(const xr::Frame& frame);
  void touch(const xr::Frame& frame, const std::array<xr::Hand, xr::kHands>& hands);
  void come_to_rest();
  void ask_for(const std::optional<Command>& command);
  const TickRecord& shown_record();
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
  std::unique_ptr<Panel> panel_;          // null: nothing is said
  std::unique_ptr<Colocated> colocated_;  // null: nobody asked
  XrTime said_ = 0;                       // ns of the runtime's clock: when the panel was written last
  ScenePictures pictures_;
  ToolInHands tool_;
  app::ButtonCommands device_buttons_;
  app::WindowSound sound_;
  std::unique_ptr<Worn> worn_;  // null: the headset is lost, or not found yet
  int unseen_ = kBlink;         // so many pictures in a row showed nothing; at first, none has shown anything
  bool began_ = false;          // the haptic thread
  bool paused_ = false;         // the stop that there is, is that of a headset that showed nothing
  std::string stopped_by_;    // what the stop that there is came of; empty: somebody asked for it, or a fault
  bool was_stopped_ = false;  // the force, when ticks were taken last
  bool held_up_ = false;      // by what did not answer, for too long, since then
  bool resting_ = false;      // the trial has ended, and the force is told to go
  std::function<void()> ended_;  // null: it has been called
  std::chrono::steady_clock::time_point ended_at_{};
  app::Comparison with_;
  std::optional<ui::Debrief> card_;  // what came of the trial, once it has ended, where a panel says it
  bool card_said_ = false;           // it is on the panel
  bool end_shown_ = false;           // the headset has shown the trial's last moment
  bool leaves_ = false;              // whoever saw it, or nobody sees anything
  bool closing_ = false;             // the headset's runtime has ended the session
  std::string error_;                // why drawing stopped
};

}  // namespace fulcrum::headset
