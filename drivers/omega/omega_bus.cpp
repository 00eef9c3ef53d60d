#include "drivers/omega/omega_bus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

namespace fulcrum::dhd {
namespace {

constexpr std::chrono::microseconds kTurn{1000};
constexpr int kButtons = 4;  // that are asked for

// The library's axes to the device's, and back.
Vec3 ours(const Vec3& v) {
  return {v.y(), v.z(), v.x()};
}
Vec3 theirs(const Vec3& v) {
  return {v.z(), v.x(), v.y()};
}

}  // namespace

std::string why_no_omega() {
  const Result<const Library*> dhd = library();
  if (!dhd) return dhd.error().sentence;
  return (*dhd)->device_count() > 0 ? "" : "none is plugged in, or it may not be opened by you: plug one in.";
}

Result<std::unique_ptr<OmegaBus>> OmegaBus::open() {
  const Result<const Library*> dhd = library();
  if (!dhd) return dhd.error();
  const int device = (*dhd)->open();
  if (device < 0)
    return Error{std::string("its maker's library could not open it (") + (*dhd)->last_error() +
                 "): plug it in again, and close what else uses it."};
  std::unique_ptr<OmegaBus> bus(new OmegaBus(**dhd, static_cast<char>(device)));
  bus->dhd_.enable_force(1, bus->device_);
  return bus;
}

OmegaBus::~OmegaBus() {
  dhd_.enable_force(0, device_);
  dhd_.close(device_);
}

// Where its arms are is known once its own calibration was done, after it was switched on.
ForceBus::Turn OmegaBus::exchange(const DeviceCommand& command, DeviceSample& sample) {
  std::this_thread::sleep_until(due_);
  due_ = std::max(due_ + kTurn, std::chrono::steady_clock::now());
  if (!calibrated_) {
    std::array<int, kStatusWords> status{};
    if (dhd_.status(status.data(), device_) < 0) return Turn::lost;
    calibrated_ = status[kStatusCalibrated] != 0;
    if (!calibrated_) return Turn::none;
  }
  const Vec3 f = theirs(command.F_H_D.force), t = theirs(command.F_H_D.torque);
  if (dhd_.set_force(f.x(), f.y(), f.z(), t.x(), t.y(), t.z(), device_) < 0) return Turn::lost;
  Vec3 p;
  double turn[3][3];
  if (dhd_.frame(&p.x(), &p.y(), &p.z(), turn, device_) < 0) return Turn::lost;
  Mat3 R;
  for (int axis = 0; axis < 3; ++axis) {
    // The image of our axis: where theirs that lies along it goes.
    const int of = (axis + 1) % 3;
    R.col(axis) = ours({turn[0][of], turn[1][of], turn[2][of]});
  }
  sample.X_DH = {Quat(R).normalized(), ours(p)};
  sample.age = 0;
  sample.buttons = 0;
  for (int number = 0; number < kButtons; ++number)
    if (dhd_.button(number, device_) > 0) sample.buttons |= 1u << number;
  return Turn::fresh;
}

std::string OmegaBus::trouble() const {
  if (calibrated_) return {};
  return "it is not calibrated: switch it on and move its handle to all ends of its way, until its light "
         "says that it is done.";
}

}  // namespace fulcrum::dhd
