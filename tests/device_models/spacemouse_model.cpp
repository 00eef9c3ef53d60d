#include "tests/device_models/spacemouse_model.h"

#include <algorithm>

namespace fulcrum::test {
namespace {

// Three axes of 16 bits in each of reports 1 and 2, 32 buttons in report 3.
Bytes cap_descriptor() {
  Bytes all{0x05, 0x01, 0x09, 0x08, 0xA1, 0x01};  // generic desktop, multi-axis controller, application
  for (const std::uint8_t number : {std::uint8_t{1}, std::uint8_t{2}}) {
    const auto first = static_cast<std::uint8_t>(number == 1 ? 0x30 : 0x33);  // X or Rx
    const Bytes axes{0xA1, 0x00,  0x85, number,
                     0x16, 0xA2,  0xFE, 0x26,
                     0x5E, 0x01,  // -350 to 350
                     0x19, first, 0x29, static_cast<std::uint8_t>(first + 2),
                     0x75, 0x10,  0x95, 0x03,
                     0x81, 0x06,  0xC0};
    all.insert(all.end(), axes.begin(), axes.end());
  }
  const Bytes buttons{0xA1, 0x00, 0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29, 0x10, 0x15,
                      0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x10, 0x81, 0x02, 0xC0, 0xC0};
  all.insert(all.end(), buttons.begin(), buttons.end());
  return all;
}

}  // namespace

SpaceMouseModel::SpaceMouseModel()
    : HidModel({.id = {0x256f, 0xc635},
                .maker = "3Dconnexion",
                .name = "SpaceMouse Compact",
                .descriptor = cap_descriptor()}) {}

void SpaceMouseModel::begin() {
  const std::lock_guard lock(mutex_);
  at_rest_ = {true, true};
  buttons_said_ = 0;
}

void SpaceMouseModel::push(const std::array<int, 6>& readings) {
  const std::lock_guard lock(mutex_);
  readings_ = readings;
}

void SpaceMouseModel::press(std::uint16_t buttons) {
  const std::lock_guard lock(mutex_);
  buttons_ = buttons;
}

std::optional<Bytes> SpaceMouseModel::say() {
  const std::lock_guard lock(mutex_);
  const auto low_first = [](Bytes& report, int value) {
    report.push_back(static_cast<std::uint8_t>(value & 0xFF));
    report.push_back(static_cast<std::uint8_t>((value >> 8) & 0xFF));
  };
  if (buttons_ != buttons_said_) {
    Bytes report{3};
    low_first(report, buttons_said_ = buttons_);
    return report;
  }
  for (int turn = 0; turn < 2; ++turn) {
    const std::size_t which = next_;
    next_ = 1 - next_;
    const auto axes = std::span(readings_).subspan(3 * which, 3);
    const bool rests = std::ranges::all_of(axes, [](int reading) { return reading == 0; });
    if (rests && at_rest_[which]) continue;
    at_rest_[which] = rests;
    Bytes report{static_cast<std::uint8_t>(1 + which)};
    for (const int reading : axes) low_first(report, reading);
    return report;
  }
  return std::nullopt;
}

}  // namespace fulcrum::test
