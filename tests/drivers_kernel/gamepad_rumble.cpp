#include "tests/drivers_kernel/gamepad_rumble.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <filesystem>

namespace fulcrum::test {
namespace {

bool rumbles(int file) {
  std::array<std::uint8_t, FF_MAX / 8 + 1> kinds{};
  return ioctl(file, EVIOCGBIT(EV_FF, kinds.size()), kinds.data()) >= 0 &&
         (kinds[FF_RUMBLE / 8] >> (FF_RUMBLE % 8) & 1) != 0;
}

}  // namespace

std::unique_ptr<GamepadRumble> GamepadRumble::find() {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/input", none)) {
    const int file = open(entry.path().c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) continue;
    if (rumbles(file)) return std::unique_ptr<GamepadRumble>(new GamepadRumble(file));
    close(file);
  }
  return nullptr;
}

GamepadRumble::~GamepadRumble() {
  close(file_);  // which stops it
}

bool GamepadRumble::play(std::uint16_t strong, std::uint16_t weak) {
  ff_effect effect{};
  effect.type = FF_RUMBLE;
  effect.id = effect_;
  effect.replay.length = 60'000;  // ms
  effect.u.rumble.strong_magnitude = strong;
  effect.u.rumble.weak_magnitude = weak;
  if (ioctl(file_, EVIOCSFF, &effect) < 0) return false;
  effect_ = effect.id;
  return begin(1);
}

bool GamepadRumble::stop() {
  return begin(0);
}

bool GamepadRumble::begin(int times) {
  input_event event{};
  event.type = EV_FF;
  event.code = static_cast<__u16>(effect_);
  event.value = times;
  return write(file_, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
}

}  // namespace fulcrum::test
