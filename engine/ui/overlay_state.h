#pragma once
// What the overlay shows, in plain data.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/render/frame_state.h"
#include "engine/ui/look.h"
#include "engine/ui/settings_page.h"
#include "engine/ui/start_page.h"
#include "engine/ui/target_state.h"
#include "engine/ui/timeline.h"

namespace fulcrum::ui {

// A dial: the magnitude that the hand feels, and the most that the device may give.
struct Dial {
  double value = 0.0;
  double limit = 0.0;  // 0: no such actuator, and the dial is left out
};

struct CheckpointLine {
  std::string name;
  render::MarkerState state;  // hidden: still to come
};

// What should not be, and how often it was: "Hard touches", 3.
struct CountLine {
  std::string name;
  std::int64_t count = 0;
};

// The trial's clock, and how long to stay at a checkpoint.
struct TrialTime {
  double now_s = 0.0;
  double limit_s = 0.0;
  double dwell_s = 0.0;  // 0: to be there is enough
};

// What came of a trial.
struct Debrief {
  struct Row {
    std::string name;   // "Peak force"
    std::string value;  // "2.13 N"
    std::optional<std::string> points{};
    std::string reason{};  // what the value is measured against
  };
  std::string title;  // "Completed in 44.1 s"
  std::vector<Row> rows;
  std::string foot;  // what to do now
};

// How the haptic thread is doing.
struct TickHealth {
  double rate_Hz = 0.0;
  double frames_per_s = 0.0;  // of the picture; 0: not known yet
  std::uint64_t late = 0;
  std::uint64_t lost = 0;
  double cpu_p50_us = 0.0;
  double cpu_p99_us = 0.0;
  bool trouble = false;  // late or lost ones have become more of late
};

struct KeyLine {
  std::string key;      // "Esc"
  std::string meaning;  // "stop all force"
};

// What a person can set of an effect: a switch, a gain and how strong it is now.
struct CueLine {
  std::string effect;  // "Torque substitution": the heading of those that follow each other
  std::string name;    // "Vibration"
  std::string key;     // that switches it
  double gain = 0.0;   // 0: off
  double level = 0.0;  // 0..1
};

// A motor, in fractions of its limit.
struct MotorBar {
  std::string name;   // "lower yaw"
  double load = 0.0;  // -1..1
  double low = 0.0;   // the largest of the last moments to this side of 0, and to the other
  double high = 0.0;
};

// Where the hand holds a stick, and what follows from it.
struct HoldingPanel {
  double place = 0.0;            // m along the stick, what is used
  double low = 0.0, high = 0.0;  // m, its ends
  bool measured = false;         // the strip under the hand is listened to
  std::string sensed;            // what it says, in words
  bool sensed_well = true;
  std::optional<double> stiffness{};  // N/m, of what is touched; none: a constraint, which has none
  std::optional<double> pending{};    // N/m, asked for: comes into force once nothing is touched
  std::vector<double> levels;         // (n) N/m, ascending, that it may have; none: it stays
  bool structure_known = false;       // how stiff the device itself is
  double limit = 0.0;                 // N/m, that its structure renders there; 0: nothing is touched
  std::vector<std::string>
      methods{};           // against the device's inertia, that do something here; none: nothing does
  std::size_t method = 0;  // index of the one in use
  bool faded = false;      // it would add energy
};

// Something that takes long, before there is a scene to show.
struct Busy {
  std::string title;      // "A spanner behind the pipes"
  std::string what;       // "Baking the distance field"
  double fraction = 0.0;  // 0..1 done
  std::string note;       // why it takes so long, or what is next; empty: none
};

enum class Force { on, stopped, returning };  // returning: after Enter, on its way back to full strength

// A place that an author drags.
struct HandleMark {
  glm::vec2 place{0.0F};  // px
  std::string name;
  bool chosen = false;  // it is held, or the next to be put
};

struct OverlayState {
  Look look;
  std::optional<Busy> busy;              // if there, it is all that is shown
  std::optional<StartPage> start;        // the same
  std::optional<SettingsPage> settings;  // the same
  double time_s = 0.0;                   // simulated time, for peaks that are held and banners that pulse
  std::string scenario;                  // heading of the checkpoints
  Dial force_N;
  Dial torque_Nm;
  std::vector<CheckpointLine> checkpoints;  // empty: no list
  std::vector<CountLine> faults;            // below them; empty: the task counts none
  std::optional<TrialTime> trial;           // above them; none: no clock
  std::optional<Target> target;             // none: nothing shows the way
  std::optional<EdgePlace> tool;            // none: it is in the picture
  std::vector<TouchMark> touches;           // px; empty: nothing is touched, or it is not to be shown
  std::vector<HandleMark> handles;          // empty: nobody edits, or nobody asks
  std::optional<SecondView> second_view;    // none: there is one view alone
  std::optional<Debrief> debrief;           // none: the trial has not ended
  std::optional<Timeline> timeline;         // none: the trial has not ended
  std::vector<CueLine> cues;                // empty: no panel
  std::string variant;                      // of the study that the switches amount to; read with the cues
  bool torque_bad = false;                  // no force tells of it; read with the cues
  bool tells_torque = true;                 // the first cues do, in a line below their heading
  std::optional<HoldingPanel> holding;      // none: no panel
  std::vector<MotorBar> motors;             // empty: no panel
  TickHealth ticks;
  bool figures_visible = false;  // those of the ticks; without them only trouble is told
  Force force = Force::on;
  std::string stop_reason;    // "Esc pressed"; shown while stopped
  bool pad = false;           // a gamepad is there, whose A goes on as Enter does
  std::string device;         // "Simulated hand"
  std::string hint;           // below it, "F1: keys"; empty: none
  std::string view;           // beside that, the name of the view; empty: none
  std::string message;        // sentences at the bottom, a line each; empty: none
  std::optional<bool> muted;  // the sound; none: there is no sound
  bool keys_visible = false;
  std::size_t keys_page = 0;  // of the keys, where the picture has no room for all of them
  std::vector<KeyLine> keys;
  std::vector<std::string> mapping;  // lines below the keys: how the device or the mouse moves the tool
};

}  // namespace fulcrum::ui
