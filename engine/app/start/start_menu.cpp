#include "engine/app/start/start_menu.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

#include "engine/app/start/ring.h"
#include "engine/session/identity.h"

namespace fulcrum::app {
namespace {

using Part = ui::StartPage::Part;

constexpr std::size_t kMostBytes = 256;  // of a name while it is written: four a letter

// The first of P01, P02, ... that nobody has.
std::string new_pseudonym(const std::vector<std::string>& taken) {
  for (int number = 1;; ++number) {
    char name[16];
    std::snprintf(name, sizeof name, "P%02d", number);
    if (std::ranges::find(taken, name) == taken.end()) return name;
  }
}

void append_utf8(std::string& to, char32_t letter) {
  const auto byte = [&](char32_t value) { to += static_cast<char>(value); };
  if (letter < 0x80) {
    byte(letter);
  } else if (letter < 0x800) {
    byte(0xc0 | (letter >> 6U));
    byte(0x80 | (letter & 0x3fU));
  } else if (letter < 0x10000) {
    byte(0xe0 | (letter >> 12U));
    byte(0x80 | ((letter >> 6U) & 0x3fU));
    byte(0x80 | (letter & 0x3fU));
  } else {
    byte(0xf0 | (letter >> 18U));
    byte(0x80 | ((letter >> 12U) & 0x3fU));
    byte(0x80 | ((letter >> 6U) & 0x3fU));
    byte(0x80 | (letter & 0x3fU));
  }
}

void erase_letter(std::string& text) {
  while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80U) text.pop_back();
  if (!text.empty()) text.pop_back();
}

// The button beside one, if there is one.
Part beside(Part button, int by) {
  const int to = static_cast<int>(button) + by;
  return static_cast<Part>(std::clamp(to, static_cast<int>(Part::start), static_cast<int>(Part::end)));
}

std::size_t index_of(const auto& list, const auto& what, auto member) {
  const auto found = std::ranges::find(list, what, member);
  return found == list.end() ? 0 : static_cast<std::size_t>(found - list.begin());
}

}  // namespace

StartMenu::StartMenu(std::vector<StartScenario> scenarios, std::vector<StartDevice> devices,
                     std::vector<std::string> participants, const StartChoice& choice)
    : scenarios_(std::move(scenarios)),
      devices_(std::move(devices)),
      scenario_(index_of(scenarios_, choice.scenario, &StartScenario::name)),
      device_(index_of(devices_, choice.device, &StartDevice::name)),
      left_handed_(choice.left_handed) {
  std::string unused = new_pseudonym(participants);
  participants_.emplace_back();
  participants_.insert(participants_.end(), participants.begin(), participants.end());
  participants_.push_back(std::move(unused));
  participant_ = index_of(participants_, choice.participant, std::identity());
}

void StartMenu::move(int by) {
  // All that can be in focus, as one column.
  const std::size_t count = scenarios_.size() + settings + 3;
  std::size_t at = 0;
  switch (focus_) {
    case Part::scenario:
      at = scenario_;
      break;
    case Part::setting:
      at = scenarios_.size() + setting_;
      break;
    case Part::start:
      at = scenarios_.size() + settings;
      break;
    case Part::settings:
      at = count - 2;
      break;
    case Part::end:
      at = count - 1;
      break;
  }
  at = turned(at, by, count);
  if (at < scenarios_.size()) {
    focus_ = Part::scenario;
    scenario_ = at;
  } else if (at < scenarios_.size() + settings) {
    focus_ = Part::setting;
    setting_ = at - scenarios_.size();
  } else {
    focus_ = at + 1 == count ? Part::end : at + 2 == count ? Part::settings : Part::start;
  }
}

void StartMenu::change(std::size_t setting, int by) {
  if (setting == who) participant_ = turned(participant_, by, participants_.size());
  if (setting == device) device_ = turned(device_, by, devices_.size());
  if (setting == hand) left_handed_ = !left_handed_;
}

StartMenu::Wish StartMenu::accept() {
  switch (focus_) {
    case Part::setting:
      if (setting_ == device) return accept_device();
      if (setting_ == who)
        written_ = "";
      else
        change(setting_, 1);
      return Wish::none;
    case Part::settings:
      return Wish::settings;
    case Part::end:
      return Wish::end;
    case Part::scenario:
    case Part::start:
      break;
  }
  if (scenarios_.empty()) return Wish::none;
  if (const std::string& fault = scenarios_[scenario_].fault; !fault.empty()) {
    note_ = fault;
    return Wish::none;
  }
  return Wish::start;
}

StartMenu::Wish StartMenu::accept_device() {
  if (devices_[device_].name != kShown) return Wish::test;
  note_ = "There is nothing to test: the expert's hand is simulated.";
  return Wish::none;
}

bool StartMenu::finish_name() {
  const std::string name = *written_;
  if (const std::optional<Error> refused = session::refuse_pseudonym(name); refused && !name.empty()) {
    note_ = refused->sentence;
    return false;
  }
  written_.reset();
  if (name.empty()) return true;
  participant_ = index_of(participants_, name, std::identity());
  if (participant_ != 0) return true;
  participants_.insert(participants_.end() - 1, name);
  participant_ = participants_.size() - 2;
  return true;
}

StartMenu::Wish StartMenu::press(Key key) {
  note_.clear();
  if (written_) {
    if (key == Key::accept) finish_name();
    if (key == Key::back) written_.reset();
    if (key == Key::erase) erase_letter(*written_);
    return Wish::none;
  }
  switch (key) {
    case Key::up:
      move(-1);
      break;
    case Key::down:
      move(1);
      break;
    case Key::left:
    case Key::right:
      if (focus_ == Part::setting) change(setting_, key == Key::left ? -1 : 1);
      if (focus_ == Part::scenario && key == Key::right)
        focus_ = Part::start;
      else if (focus_ >= Part::start)
        focus_ = beside(focus_, key == Key::left ? -1 : 1);
      break;
    case Key::accept:
      return accept();
    case Key::back:
      if (focus_ == Part::scenario) return Wish::end;
      focus_ = Part::scenario;
      break;
    case Key::erase:
      break;
  }
  return Wish::none;
}

void StartMenu::type(char32_t letter) {
  if (written_ && letter >= 0x20 && letter < 0x110000 && written_->size() + 4 <= kMostBytes)
    append_utf8(*written_, letter);
}

StartMenu::Wish StartMenu::click(const ui::StartHit& hit) {
  note_.clear();
  if (written_ && !finish_name()) return Wish::none;  // else it would be somebody else's trial
  switch (hit.part) {
    case Part::scenario:
      // A second press on what is chosen starts it.
      if (focus_ == Part::scenario && scenario_ == hit.index) return accept();
      focus_ = Part::scenario;
      scenario_ = hit.index;
      return Wish::none;
    case Part::setting:
      focus_ = Part::setting;
      setting_ = hit.index;
      if (hit.side == 0) return accept();
      change(hit.index, hit.side);
      return Wish::none;
    case Part::start:
    case Part::settings:
    case Part::end:
      focus_ = hit.part;
      return accept();
  }
  return Wish::none;
}

void StartMenu::set_bests(const std::vector<std::optional<double>>& bests) {
  for (std::size_t i = 0; i < scenarios_.size(); ++i)
    scenarios_[i].best = i < bests.size() ? bests[i] : std::nullopt;
}

StartChoice StartMenu::choice() const {
  return {participants_[participant_], devices_[device_].name, left_handed_,
          scenarios_.empty() ? std::string() : scenarios_[scenario_].name};
}

ui::StartPage StartMenu::page() const {
  ui::StartPage page;
  for (const StartScenario& scenario : scenarios_) {
    std::string best;
    if (scenario.best) best = "best " + std::to_string(std::lround(*scenario.best));
    page.scenarios.push_back({scenario.title, std::move(best), scenario.fault.empty()});
  }
  page.chosen = scenario_;
  if (!scenarios_.empty()) {
    page.about = scenarios_[scenario_].about;
    page.facts =
        scenarios_[scenario_].fault.empty() ? scenarios_[scenario_].facts : scenarios_[scenario_].fault;
  } else {
    page.about = "No scenarios were found: build them (tools/run --build), or set FULCRUM_CONTENT.";
  }
  const std::string& name = participants_[participant_];
  std::string trainee = name.empty() ? "nobody, not kept" : name;
  if (participant_ + 1 == participants_.size()) trainee += " (new)";
  page.settings = {{"Who trains", written_ ? *written_ : trainee, written_.has_value()},
                   {"Device", devices_[device_].label},
                   {"Hand", left_handed_ ? "left" : "right"}};
  page.focus = focus_;
  page.index = focus_ == Part::setting ? setting_ : scenario_;
  page.note = note_;
  const bool at_device = focus_ == Part::setting && setting_ == device;
  page.help = written_    ? "Type a pseudonym, then Enter; Esc leaves it as it was"
              : at_device ? "Left, right: another one; Enter tests it"
              : focus_ == Part::scenario || focus_ == Part::start ? "Arrows choose, Enter starts, Esc ends"
              : focus_ != Part::setting                           ? "Enter presses the button, Esc goes back"
              : setting_ == who ? "Left, right: another one; Enter writes a new name"
                                : "Left, right or Enter: the other hand";
  return page;
}

}  // namespace fulcrum::app
