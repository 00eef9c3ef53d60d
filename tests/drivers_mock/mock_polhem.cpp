#include "tests/drivers_mock/mock_polhem.h"

#include <array>

namespace fulcrum::test {
namespace {

// Seven numbers, low byte first, as the board of a Polhem says and hears them.
Bytes board_report(const std::array<int, 7>& numbers) {
  Bytes report;
  for (const int number : numbers) {
    report.push_back(static_cast<std::uint8_t>(number & 255));
    report.push_back(static_cast<std::uint8_t>(number >> 8 & 255));
  }
  return report;
}

// Its descriptor is a vendor's own.
MockHidFacts polhem() {
  return {.id = {0x1234, 0x0006},
          .name = "mbed",
          .descriptor = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x75, 0x08, 0x95, 0x0E,
                         0x09, 0x01, 0x81, 0x02, 0x95, 0x0E, 0x09, 0x01, 0x91, 0x02, 0xC0}};
}

}  // namespace

DeviceDesc polhem_desc() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::arms;
  desc.mechanism.q_DK = Quat(0.5, -0.5, -0.5, -0.5);
  desc.mechanism.arms = {
      {"arm",
       {{.name = "yaw", .axis_K = {0, 0, 1}, .max_torque = 1.936},
        {.name = "shoulder", .axis_K = {0, -1, 0}, .point_K = {0, 0, 0.058}, .home = -0.4393498},
        {.name = "elbow",
         .axis_K = {0, -1, 0},
         .point_K = {0, 0, 0.232},
         .home = 0.9585170,
         .through_parallelogram = true}},
       Vec3(0, 0, 0.099)}};
  return desc;
}

MockPolhem::MockPolhem(MockMachine& machine) : hid_(machine, polhem()), firmware_([this] { answer_on(); }) {}

MockPolhem::~MockPolhem() {
  on_ = false;
  firmware_.join();
}

void MockPolhem::answer_on() {
  for (; on_; std::this_thread::yield()) {
    const std::lock_guard lock(mutex_);
    const std::size_t heard = hid_.times_written();
    if (!plugged_ || heard == answered_ || !hid_.all_read()) continue;
    answered_ = heard;
    if (hid_.last_written()[7] == 1) asks_ = false;
    if (const int yaw = yaw_; yaw != said_.yaw) said_ = {yaw, MockHid::Clock::now()};
    hid_.say(board_report({said_.yaw, 0, -4000, 0, 0, 0, asks_ ? 1 : 0}));
  }
}

MockPolhem::Said MockPolhem::said() {
  const std::lock_guard lock(mutex_);
  return said_;
}

void MockPolhem::unplug() {
  const std::lock_guard lock(mutex_);
  plugged_ = false;
  hid_.unplug();
}

void MockPolhem::plug() {
  const std::lock_guard lock(mutex_);
  answered_ = hid_.times_written();
  asks_ = true;
  hid_.plug();
  plugged_ = true;
}

int MockPolhem::current_in(const Bytes& heard) {
  return static_cast<std::int16_t>(heard[1] + 256 * heard[2]);
}

}  // namespace fulcrum::test
