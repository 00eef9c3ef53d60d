#include "engine/app/start/start_window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "drivers/registry.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/prepare/run_request.h"
#include "engine/app/settings/settings.h"
#include "engine/app/start/backdrop.h"
#include "engine/app/start/device_test_page.h"
#include "engine/app/start/settings_panel.h"
#include "engine/app/start/start_menu.h"
#include "engine/app/start/start_settings.h"
#include "engine/app/window/pad_device.h"
#include "engine/app/window/train.h"
#include "engine/input/pad_presses.h"
#include "engine/report/axis.h"
#include "engine/scenario/content.h"
#include "engine/ui/pads.h"

namespace fulcrum::app {
namespace {

using namespace std::chrono_literals;
using Key = StartMenu::Key;
using Wish = StartMenu::Wish;

constexpr auto kFramePause = 15ms;  // between frames: nothing moves fast here

std::vector<StartScenario> scenarios() {
  std::vector<StartScenario> all;
  for (const scenario::ScenarioListing& listed : scenario::list_scenarios()) {
    StartScenario one{.name = listed.name,
                      .title = listed.title,
                      .about = listed.about,
                      .facts = {},
                      .fault = listed.fault};
    if (one.title.empty()) one.title = one.name;
    if (listed.fault.empty()) {
      if (listed.difficulty) one.facts.append(name_of(*listed.difficulty)).append(", ");
      one.facts += std::to_string(listed.checkpoints) + " checkpoints in " +
                   report::short_number(listed.time_limit) + " s";
    }
    all.push_back(std::move(one));
  }
  return all;
}

// What can be held now, the best first; then nothing at all.
std::vector<StartDevice> devices() {
  std::vector<StartDevice> all;
  for (const DeviceListing& listed : list_devices("")) {
    const bool held = listed.present && !listed.beside_alone && !is_simulated(listed.name) &&
                      !listed.name.starts_with("replay");
    if (held) all.push_back({listed.name, listed.name});
  }
  const std::string best = best_device("").name;
  std::stable_partition(all.begin(), all.end(),
                        [&](const StartDevice& device) { return device.name == best; });
  all.push_back({kShown, "none: the expert shows it"});
  return all;
}

// The results, where there are any: looking leaves no file behind.
std::optional<session::Store> results() {
  const Result<std::filesystem::path> file = session::Store::default_file();
  std::error_code unknown;
  if (!file || !std::filesystem::exists(*file, unknown)) return std::nullopt;
  Result<session::Store> store = session::Store::open(*file);
  if (!store) {
    complain(store.error().sentence);
    return std::nullopt;
  }
  return std::move(*store);
}

std::vector<std::string> participants(const std::optional<session::Store>& store) {
  std::vector<std::string> names;
  if (!store) return names;
  const Result<std::vector<session::Participant>> all = store->participants();
  if (!all) return names;
  for (const session::Participant& one : *all) names.push_back(one.name);
  return names;
}

std::vector<std::optional<double>> bests(const std::optional<session::Store>& store,
                                         const std::vector<StartScenario>& scenarios,
                                         const std::string& participant) {
  std::vector<std::optional<double>> all;
  for (const StartScenario& scenario : scenarios) {
    std::optional<double> best;
    if (store && !participant.empty())
      if (const auto found = store->best_score(participant, scenario.name); found) best = *found;
    all.push_back(best);
  }
  return all;
}

std::optional<Key> key_of(int key) {
  switch (key) {
    case GLFW_KEY_UP:
      return Key::up;
    case GLFW_KEY_DOWN:
    case GLFW_KEY_TAB:
      return Key::down;
    case GLFW_KEY_LEFT:
      return Key::left;
    case GLFW_KEY_RIGHT:
      return Key::right;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return Key::accept;
    case GLFW_KEY_ESCAPE:
      return Key::back;
    case GLFW_KEY_BACKSPACE:
      return Key::erase;
    default:
      return std::nullopt;
  }
}

// What a gamepad's buttons ask of the menu.
constexpr std::pair<std::uint32_t, Key> kPadKeys[] = {{ui::kPadUp, Key::up},     {ui::kPadDown, Key::down},
                                                      {ui::kPadLeft, Key::left}, {ui::kPadRight, Key::right},
                                                      {ui::kPadA, Key::accept},  {ui::kPadStart, Key::accept},
                                                      {ui::kPadB, Key::back}};
constexpr std::uint32_t kPadCross = ui::kPadUp | ui::kPadDown | ui::kPadLeft | ui::kPadRight;

// Until something is wished for, or the window is closed.
Result<Wish> ask(WindowStage& stage, StartMenu& menu, const std::optional<session::Store>& store,
                 const std::vector<StartScenario>& scenarios) {
  if (auto error = stage.clear_scene()) return *error;  // of what was trained
  Wish wish = Wish::none;
  double x = 0, y = 0;
  SettingsPanel settings(stage);
  const auto follow = [&](Wish wished) {
    if (wished == Wish::settings)
      settings.open();
    else
      wish = wished;
  };
  const auto press = [&](Key key) {
    if (wish != Wish::none) return;
    if (settings.is_open())
      settings.press(key);
    else
      follow(menu.press(key));
  };
  ui::WindowEvents events;
  events.key = [&](int key, int action, int) {
    if (action == GLFW_RELEASE) return;
    if (const auto pressed = key_of(key)) press(*pressed);
  };
  events.text = [&](char32_t letter) { menu.type(letter); };
  events.cursor = [&](double to_x, double to_y) {
    x = to_x;
    y = to_y;
  };
  events.button = [&](int button, int action, int) {
    if (button != GLFW_MOUSE_BUTTON_LEFT || action != GLFW_PRESS || wish != Wish::none) return;
    if (settings.is_open()) return settings.press_at(x, y);
    if (const auto hit = ui::start_hit(menu.page(), stage.window().pixels(), stage.settings().look, x, y))
      follow(menu.click(*hit));
  };
  events.scroll = [&](double, double steps) { press(steps > 0 ? Key::up : Key::down); };
  stage.window().set_events(events);
  ui::learn_pads(gamepad_mappings());
  input::PadPresses pad(kPadCross);
  Backdrop backdrop(stage);
  std::optional<std::string> asked_about;
  while (wish == Wish::none && !interrupted()) {
    const StartChoice choice = menu.choice();
    if (choice.participant != asked_about) {
      asked_about = choice.participant;
      menu.set_bests(bests(store, scenarios, choice.participant));
    }
    backdrop.want(choice.scenario, choice.left_handed);
    ui::OverlayState state;
    state.look = stage.settings().look;
    state.start = menu.page();
    if (settings.is_open()) state.settings = settings.page();
    const Result<bool> open = stage.show(state, backdrop.frame());
    if (!open) return open.error();
    if (!*open) wish = Wish::end;
    const std::uint32_t buttons = pad.pressed(ui::menu_buttons(ui::pad_states()), seconds_now());
    for (const auto& [button, key] : kPadKeys)
      if ((buttons & button) != 0) press(key);
    if (wish == Wish::test) {
      const Result<std::string> refused = test_device(stage, backdrop, menu.page(), menu.choice().device);
      if (!refused) return refused.error();
      menu.set_note(*refused);
      stage.window().set_events(events);
      pad = input::PadPresses(kPadCross);
      wish = Wish::none;
    }
    std::this_thread::sleep_for(kFramePause);
  }
  stage.window().set_events({});
  if (auto error = stage.clear_scene()) return *error;
  return wish == Wish::start ? Wish::start : Wish::end;
}

RunOptions options_of(const StartChoice& choice) {
  RunOptions options;
  options.scenario = choice.scenario;
  const bool shown = choice.device == kShown;
  options.device = shown ? "simulated" : choice.device;
  options.participant = shown ? "" : choice.participant;  // what the expert does is nobody's
  if (choice.left_handed) options.overrides.emplace_back("left_handed=true");
  return options;
}

}  // namespace

int run_start_window() {
  KeptComplaints complaints;
  const Result<std::unique_ptr<WindowStage>> stage =
      WindowStage::create("Fulcrum", RunOptions(), read_settings());
  if (!stage) {
    complain(stage.error().sentence);
    return kError;
  }
  catch_interrupts();
  StartChoice choice = read_start_choice();
  std::optional<Participation> participation;
  for (;;) {
    const std::optional<session::Store> store = results();
    const std::vector<StartScenario> listed = scenarios();
    StartMenu menu(listed, devices(), participants(store), choice);
    menu.set_note(complaints.take());
    const Result<Wish> wish = ask(**stage, menu, store, listed);
    choice = menu.choice();
    write_start_choice(choice);
    if (!wish) {
      complain(wish.error().sentence);
      return kError;
    }
    if (*wish == Wish::end) return kCompleted;
    RunOptions options = options_of(choice);
    // One session for as long as the same person trains.
    if (!participation || participation->session.participant != options.participant) {
      participation.reset();
      if (!options.participant.empty()) {
        Result<Participation> begun = Participation::begin(options.participant);
        if (!begun) {
          complain(begun.error().sentence);
          continue;
        }
        participation = std::move(*begun);
      }
    }
    const RequestedRun requested = request_run(options, "");
    if (!requested.scenario) continue;
    const Trained trained =
        train(**stage, *requested.scenario, options, participation ? &*participation : nullptr, true);
    if (trained.leave == TrainingWindow::Leave::closed) return kCompleted;
    // What was said on the way to a trial that ran is no news on the start page.
    if (trained.code != kError) complaints.take();
  }
}

}  // namespace fulcrum::app
