#include "engine/app/start/device_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "engine/app/prepare/capabilities.h"
#include "engine/app/window/pad_controls.h"
#include "haptics/math/rotation.h"

namespace fulcrum::app {
namespace {

constexpr double kTick = 1e-3;          // s
constexpr int kMostTicks = 100;         // of one look, after a window that stood still
constexpr double kMoved = 0.25;         // of what an axis reaches, that is no chance
constexpr double kTurns = 1.0;          // rad, that a bar shows of a handle's turn
constexpr double kMouseReaches = 0.1;   // m, that a bar shows
constexpr double kMouseStep = 5e-3;     // m, of the wheel
constexpr double kPictureHeight = 0.2;  // m, of a drag across

constexpr const char* kNames[] = {"right", "up", "toward you", "tilt", "turn", "roll"};

// The push that has a cap or a stick move so fast.
double push_of(double speed, double full) {
  return std::copysign(std::sqrt(std::min(std::abs(speed) / full, 1.0)), speed);
}

// (3) rad, from one pose to the other.
Vec3 turn_between(const Pose& from, const Pose& to) {
  return rotation_vector((to.q * from.q.conjugate()).normalized());
}

std::string number(const char* pattern, double value) {
  char text[32];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string buttons_down(std::uint32_t bits) {
  std::string names;
  for (int bit = 0; bit < 32; ++bit)
    if (((bits >> static_cast<unsigned>(bit)) & 1U) != 0)
      names += (names.empty() ? "" : ", ") + std::to_string(bit + 1);
  return names;
}

std::string pad_buttons_down(std::uint32_t bits) {
  constexpr std::pair<std::uint32_t, const char*> kButtons[] = {{ui::kPadA, "A"},
                                                                {ui::kPadB, "B"},
                                                                {ui::kPadX, "X"},
                                                                {ui::kPadY, "Y"},
                                                                {ui::kPadLeftBumper, "left bumper"},
                                                                {ui::kPadRightBumper, "right bumper"},
                                                                {ui::kPadBack, "Back"},
                                                                {ui::kPadStart, "Start"},
                                                                {ui::kPadUp, "cross up"},
                                                                {ui::kPadRight, "cross right"},
                                                                {ui::kPadDown, "cross down"},
                                                                {ui::kPadLeft, "cross left"}};
  std::string names;
  for (const auto& [bit, name] : kButtons)
    if ((bits & bit) != 0) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

}  // namespace

Result<std::unique_ptr<DeviceTrial>> DeviceTrial::open(const std::string& name) {
  if (const std::optional<Error> refused = refuse_device(name, {"", true})) return *refused;
  const std::vector<DeviceListing> listed = list_devices("");
  const auto listing = std::ranges::find(listed, name, &DeviceListing::name);
  const std::optional<DeviceDesc> desc = listing == listed.end() ? std::nullopt : figures_of(*listing);
  if (!desc)
    return Error{"The table of '" + name + "' cannot be read: `fulcrum explain` says what is wrong with it."};
  Result<OpenDevice> opened = open_device(name, {.desc = *desc, .X_DH = Pose{}, .tick_s = kTick});
  if (!opened) return opened.error();
  return std::make_unique<DeviceTrial>(name, *desc, std::move(*opened));
}

DeviceTrial::DeviceTrial(std::string name, DeviceDesc desc, OpenDevice device)
    : name_(std::move(name)),
      desc_(std::move(desc)),
      device_(std::move(device)),
      mouse_({kMouseStep, kMouseStep / 4}) {}

void DeviceTrial::key(int key, int action, bool shift) {
  if (device_.keys == nullptr) return;
  keys_.note(key, action);
  device_.keys->push(keys_.axes(shift));
}

void DeviceTrial::drag(double dx, double dy, bool left, bool shift) {
  const input::ViewAxes view{.height = kPictureHeight};
  if (left)
    mouse_.slide(view, dx, dy);
  else if (shift)
    mouse_.roll(view, dx);
  else
    mouse_.turn(view, dx, dy);
}

void DeviceTrial::wheel(double steps, bool shift) {
  mouse_.reach({.height = kPictureHeight}, steps, shift ? input::Step::fine : input::Step::whole);
}

void DeviceTrial::advance(double now, std::span<const ui::PadState> pads) {
  pad_buttons_ = 0;
  for (const ui::PadState& pad : pads) pad_buttons_ |= pad.buttons;
  if (device_.gamepad != nullptr) {
    if (const std::optional<PushedAxes> axes = pad_.read(pads))
      device_.gamepad->push(*axes);
    else
      device_.gamepad->lose();
  }
  if (device_.mouse != nullptr) device_.mouse->aim(mouse_.X_WH());
  const double passed = last_ ? now - *last_ : kTick;
  if (!last_) {
    sample_ = device_.device->read();
    X_D0_ = sample_.X_DH;
  }
  last_ = now;
  read_ticks(std::clamp(static_cast<int>(std::lround(passed / kTick)), 1, kMostTicks));
}

void DeviceTrial::read_ticks(int ticks) {
  const Pose before = sample_.X_DH;
  for (int tick = 0; tick < ticks; ++tick) sample_ = device_.device->read();
  const Pose& X_DH = sample_.X_DH;
  const auto note = [this](int axis, double value, double part, double moved) {
    const auto at = static_cast<std::size_t>(axis);
    values_[at] = value;
    parts_[at] = part;
    moved_[at] = moved_[at] || std::abs(moved) > kMoved;
  };
  if (device_.rate != nullptr) {
    const RateControlDesc rate;
    const double s = ticks * kTick;
    const Vec3 v = (X_DH.p - before.p) / s, w = turn_between(before, X_DH) / s;
    for (int axis = 0; axis < 3; ++axis) {
      const double way = push_of(v[axis], rate.heights_per_s * SeenFrame().height);
      const double turn = push_of(w[axis], rate.full_turn);
      note(axis, way, way, way);
      note(axis + 3, turn, turn, turn);
    }
    return;
  }
  // A handle is shown where it is in its workspace; it may have been found anywhere there.
  const bool mouse = device_.mouse != nullptr;
  const Vec3 reach = mouse ? Vec3(Vec3::Constant(kMouseReaches)) : desc_.workspace;
  const Vec3 middle = mouse ? Vec3(Vec3::Zero()) : desc_.workspace_centre;
  const Vec3 turn = turn_between(X_D0_, X_DH);
  for (int axis = 0; axis < 3; ++axis) {
    const double way = X_DH.p[axis] - middle[axis];
    note(axis, way, way / reach[axis], (X_DH.p[axis] - X_D0_.p[axis]) / reach[axis]);
    note(axis + 3, turn[axis], turn[axis] / kTurns, turn[axis] / kTurns);
  }
}

ui::DevicePanel DeviceTrial::panel() const {
  ui::DevicePanel panel;
  panel.title = "What " + name_ + " senses";
  for (std::size_t axis = 0; axis < (desc_.senses_rotation ? kAxes : 3); ++axis) {
    const std::string value = device_.rate != nullptr ? number("%+.0f %%", 100 * values_[axis])
                              : axis < 3              ? number("%+.0f mm", 1e3 * values_[axis])
                                         : number("%+.0f deg", values_[axis] * 180 / std::numbers::pi);
    panel.axes.push_back({kNames[axis], parts_[axis], value, moved_[axis]});
  }
  const std::string down =
      device_.gamepad != nullptr ? pad_buttons_down(pad_buttons_) : buttons_down(sample_.buttons);
  panel.buttons = "Buttons down: " + (down.empty() ? "none" : down);
  if (!sample_.connected) panel.trouble = "It is gone: plug it in again.";
  if (device_.mouse != nullptr)
    panel.notes.emplace_back("Drag with the left button and with the right one, and turn the wheel.");
  else if (device_.keys != nullptr)
    panel.notes.emplace_back("Press the arrows, Page Up and Down, W and S, A and D, Q and E.");
  else if (device_.rate != nullptr)
    panel.notes.emplace_back("Push each stick, trigger or cap all ways, and press each button.");
  else
    panel.notes.emplace_back("Move the handle along each axis and turn it, and press each button.");
  panel.notes.emplace_back("A dot is green once its axis has moved.");
  if (desc_.renders_force || desc_.renders_torque)
    panel.notes.push_back("Its motors stay off here: `fulcrum device-test " + name_ + "` tries them.");
  else if (desc_.vibrotactile)
    panel.notes.push_back("It vibrates: `fulcrum device-test " + name_ + "` tries that.");
  else
    panel.notes.emplace_back("It cannot push: the picture shows the force that a hand would feel.");
  return panel;
}

}  // namespace fulcrum::app
