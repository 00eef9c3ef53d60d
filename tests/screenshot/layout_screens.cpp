#include "layout_screens.h"

#include <algorithm>
#include <utility>

#include "overlay_parts.h"

namespace fulcrum::test {
namespace {

using namespace ui;
using Show = render::MarkerState::Show;

std::vector<CheckpointLine> checkpoints(const std::vector<std::string>& names, std::size_t at, Show due) {
  std::vector<CheckpointLine> lines;
  for (std::size_t i = 0; i < names.size(); ++i)
    lines.push_back({names[i], {i < at ? Show::done : i == at ? due : Show::hidden, 0.4F}});
  return lines;
}

Target target(const std::string& name, const std::string& touch) {
  Target target;
  target.name = name;
  target.at.in_sight = true;
  target.at.place = {0.5F, 0.5F};  // parts of the picture: sized_for makes pixels of them
  target.at.radius = 30;
  target.at.distance = 0.1234;
  target.at.touch = glm::vec2(0.45F, 0.6F);
  target.dwell_s = 3;
  target.touch_name = touch;
  return target;
}

OverlayState scene(const char* title, std::vector<std::string> names, const char* about) {
  OverlayState state;
  state.time_s = 12;
  state.scenario = title;
  state.force_N = {4.0, 8.0};
  state.torque_Nm = {0.05, 0.2};
  state.checkpoints = checkpoints(names, names.size() / 2, Show::dwelling);
  state.trial = TrialTime{12, 90, 3};
  state.device = "Simulated hand, polhem";
  state.hint = "F1: keys";
  state.view = "down the canal";
  state.message = about;
  state.ticks = {1000, 12, 3, 8, 21, false};
  state.target = target(names[names.size() / 2], "the stylus's tip");
  return state;
}

OverlayState piping() {
  OverlayState state =
      scene("Spanner behind the pipes",
            {"approach", "on edge", "between the pipes", "behind the pipes", "at the nut"},
            "Take a ring spanner through a narrow slot between two pipes to a nut behind them.");
  state.cues = {{"Torque substitution", "Vibration", "V", 1.0, 0.4},
                {"Torque substitution", "Ghost", "G", 0.6, 0.0},
                {"Vibrotactile motion", "Vibration", "T", 1.0, 0.2}};
  state.variant = "variant C";
  state.torque_bad = true;
  state.target->touch_name = "the spanner's large ring";
  return state;
}

OverlayState stick() {
  OverlayState state =
      scene("A stick on a ball",
            {"touch at 80 mm", "touch at 60 mm", "touch at 100 mm", "up", "hold elsewhere", "off again"},
            "Push a soft ball with a stick, at any place of it, held at any other; the device's own mass is "
            "made up "
            "for.");
  state.holding = held_stick();
  return state;
}

OverlayState plate() {
  OverlayState state = scene(
      "Taps on a hard plate",
      {"level", "level and steep", "level and low", "tilted by 30", "tilted by 60", "upright", "off again"},
      "Tap steel plates with a stylus, level, tilted and upright, and feel how hard they are.");
  state.cues = {{"Braking pulse", "Pulse", "B", 1.0, 0.0}, {"Braking pulse", "Moment", "M", 1.0, 0.0}};
  state.tells_torque = false;
  for (const char* name :
       {"base yaw", "lower pitch", "upper pitch", "elbow yaw", "wrist yaw", "wrist pitch", "wrist roll"})
    state.motors.push_back({name, 0.5, -0.2, 0.95});
  return state;
}

OverlayState ear() {
  OverlayState state = scene(
      "Needle to the eardrum",
      {"canal opening", "first bend", "second bend", "over the umbo", "front recess"},
      "Take a bent needle along an S-shaped ear canal to the drum; it has to be rolled to pass the bends.");
  state.faults = {{"Hard touches", 3}};
  state.target->at.in_sight = false;
  state.target->at.way = {0.8F, 0.6F};
  state.target->at.place = {0.98F, 0.8F};
  state.ticks.trouble = true;
  return state;
}

OverlayState knock() {
  OverlayState state =
      scene("Knocks with a bar",
            {"rubber from above", "rubber from the right", "wood from below", "wood from the left",
             "steel from above", "steel from the left", "row of five", "off again"},
            "Knock with a bar that is held at one end against pegs of steel, wood and rubber.");
  state.cues = {{"Impact vibration", "Vibration", "I", 1.0, 0.6}};
  state.tells_torque = false;
  state.figures_visible = true;
  return state;
}

Debrief debrief() {
  return {"Completed in 44.1 s: 87 of 100 points",
          {{"Checkpoints", "5 of 5", "40 of 40",
            "They count in their order, each once the tool has stayed there."},
           {"Time", "44.1 s", "12.5 of 15", "1.67 times the expert's 26.4 s."},
           {"Path", "1234 mm", "11.2 of 15", "2.01 times the expert's 613 mm."},
           {"95th percentile of force", "4.12 N", "9.87 of 15", "2.35 times the expert's 1.75 N."},
           {"Hard touches", "3", "6 of 15", "Each costs 3 points; 0.4 s above the limit in all."},
           {"Smoothness (spectral arc length)", "-4.31", "13.1 of 15", "1.83 times the expert's -2.36."},
           {"Touches on the way", "7", "3.5 of 15", "3.50 times the expert's 1."},
           {"Mean force", "1.73 N", {}, "Over 12.3 s of contact."},
           {"Peak force", "7.31 N", {}, "Of the scene on the tool."},
           {"Depth", "0.312 mm", {}, "The deepest that a tick saw."},
           {"E_tau", "1.234 N m s", {}, "Torque of the coupling over time."},
           {"E_F", "61.42 N s", {}, "Force of contact over time."},
           {"approach", "4.1 s", {}, ""},
           {"on edge", "9.8 s", {}, ""},
           {"between the pipes", "17.3 s", {}, ""},
           {"behind the pipes", "29.0 s", {}, ""},
           {"at the nut", "-", {}, "not reached"}},
          "R starts again, F10 goes back to the start page."};
}

Timeline timeline(std::optional<double> at) {
  return {44.1,
          at,
          {{4.1, Timeline::Mark::Kind::good},
           {12.0, Timeline::Mark::Kind::fair},
           {31.0, Timeline::Mark::Kind::bad},
           {44.1, Timeline::Mark::Kind::good}},
          at ? "29.0 s, checkpoint reached: behind the pipes" : "Arrow keys look back"};
}

OverlayState ended(OverlayState state, bool looks_back) {
  state.message.clear();
  state.target.reset();
  state.timeline = timeline(looks_back ? std::optional(29.0) : std::nullopt);
  if (!looks_back) state.debrief = debrief();
  return state;
}

OverlayState with_keys(OverlayState state) {
  state.keys_visible = true;
  state.keys = {
      {"Esc", "stop force and time"},
      {"Enter", "go on; the force returns"},
      {"R", "start again"},
      {"F10", "back to the start page"},
      {"1 to 7", "views: 1 overview, 2 occlusal, 3 front, 4 buccal, 5 lingual, 6 incisors, 7 molars"},
      {"Home", "back to this view's start"},
      {"C", "show or hide the circle of confusion"},
      {"V", "switch torque substitution: vibration"},
      {"G", "switch torque substitution: ghost"},
      {"T", "switch vibrotactile motion: vibration"},
      {"Left, Right", "look back at the trial; with Shift, by a second"},
      {"Page Up, Down", "the event before, the event after"},
      {"Space", "show or hide what came of it"},
      {"F1", "show or hide this list"},
      {"F2", "show or hide the way to the next checkpoint"},
      {"F3", "show or hide the engineer's figures"}};
  state.mapping = {"Left drag: tool left, right, up, down", "Wheel: tool away and nearer",
                   "Shift + wheel: the same, finer",        "Right drag: tool turns left, right, up, down",
                   "Shift + right drag: tool rolls",        "Middle drag: look around",
                   "Shift + middle drag: move the view",    "Ctrl + wheel: zoom"};
  return state;
}

OverlayState stopped(OverlayState state, const char* reason) {
  state.force = Force::stopped;
  state.stop_reason = reason;
  return state;
}

OverlayState returning(OverlayState state) {
  state.force = Force::returning;
  return state;
}

StartPage start_page(StartPage::Part focus) {
  StartPage page;
  for (const char* title :
       {"Needle to the eardrum", "Knocks with a bar", "Spanner behind the pipes", "Taps on a hard plate",
        "A stick on a ball", "A sweep over glass", "Explorer in the lower jaw"})
    page.scenarios.push_back({title, "best 87", true});
  page.chosen = 6;
  page.about =
      "Push a soft ball with a stick, at any place of it, held at any other; the device's own mass is made "
      "up "
      "for.";
  page.facts = "6 checkpoints in 90 s";
  page.settings = {
      {"Who trains", "nobody, not kept"}, {"Device", "none: the expert shows it"}, {"Hand", "right"}};
  page.focus = focus;
  page.index = focus == StartPage::Part::setting ? 1 : 6;
  page.help = "Arrows choose, Enter starts, Esc ends";
  return page;
}

OverlayState start(StartPage page) {
  OverlayState state;
  state.start = std::move(page);
  return state;
}

// What engine/app/start/device_trial.cpp says of a device with motors, at its longest.
OverlayState device_test() {
  DevicePanel panel;
  panel.title = "What inverse3+versegrip senses";
  for (const char* axis : {"right", "up", "toward you", "pitch", "yaw", "roll"})
    panel.axes.push_back({axis, -0.7, "-128 mm", axis[0] == 'u'});
  panel.buttons = "Buttons down: A, left bumper, right bumper";
  panel.notes = {"Move the handle along each axis and turn it, and press each button.",
                 "A dot is green once its axis has moved.",
                 "Its motors stay off here: `fulcrum device-test inverse3+versegrip` tries them."};
  StartPage page = start_page(StartPage::Part::setting);
  page.tested = std::move(panel);
  return start(std::move(page));
}

OverlayState settings() {
  OverlayState state;
  state.settings = SettingsPage{
      {{"Text size", "150 %"},
       {"Colours", "for colour blindness"},
       {"Picture", "automatic"},
       {"Sound", "100 %"}},
      2,
      "Shadows and sharpness of the scene; automatic: as good as thirty pictures a second allow.",
      "Arrows choose and change, Esc goes back"};
  return state;
}

OverlayState busy() {
  OverlayState state;
  state.busy = Busy{"Spanner behind the pipes", "Baking the distance field of the pipes", 0.62,
                    "Once only: the next start finds it in the cache."};
  return state;
}

}  // namespace

std::vector<Screen> screens() {
  StartPage noted = start_page(StartPage::Part::start);
  noted.note =
      "The device is gone: plug it in again, or choose another one; what was recorded of the trial is kept.";
  return {{"start", start(start_page(StartPage::Part::scenario))},
          {"start-note", start(std::move(noted))},
          {"settings", settings()},
          {"device-test", device_test()},
          {"busy", busy()},
          {"piping", piping()},
          {"stick", stick()},
          {"plate", plate()},
          {"ear", ear()},
          {"knock", knock()},
          {"keys", with_keys(piping())},
          {"keys-stopped", stopped(with_keys(piping()), "Esc pressed")},
          {"stopped", stopped(piping(), "Esc pressed")},
          {"stopped-long", stopped(stick(), "the device has not answered for 100 ms")},
          {"returning", returning(piping())},
          {"debrief", ended(piping(), false)},
          {"look-back", ended(piping(), true)},
          {"look-back-stick", ended(stick(), true)},
          {"look-back-plate", ended(plate(), true)}};
}

OverlayState screen(const std::string& name) {
  const std::vector<Screen> all = screens();
  return std::ranges::find(all, name, &Screen::name)->state;
}

}  // namespace fulcrum::test
