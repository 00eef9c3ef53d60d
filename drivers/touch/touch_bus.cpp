#include "drivers/touch/touch_bus.h"

#include <array>
#include <chrono>

namespace fulcrum::hd {
namespace {

constexpr double kFrame = 1e-3;  // s
constexpr std::chrono::milliseconds kWait{5};
constexpr double kMetres = 1e-3;  // of the library's mm

// 16 numbers, column by column.
Pose pose_of(const std::array<double, 16>& m) {
  Mat3 R;
  R << m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10];
  return {Quat(R).normalized(), kMetres * Vec3(m[12], m[13], m[14])};
}

}  // namespace

// Only opening it tells.
std::string why_no_touch() {
  const Result<const Library*> hd = library();
  if (!hd) return hd.error().sentence;
  const unsigned device = (*hd)->init_device(nullptr);
  const ErrorInfo error = (*hd)->error();
  if (device == kNoDevice || error.code != 0)
    return std::string("its maker's library finds none (") + (*hd)->error_text(error.code) +
           "): plug one in, and try it in the maker's own set-up.";
  (*hd)->disable_device(device);
  return "";
}

Result<std::unique_ptr<TouchBus>> TouchBus::open() {
  const Result<const Library*> hd = library();
  if (!hd) return hd.error();
  const unsigned device = (*hd)->init_device(nullptr);
  const ErrorInfo error = (*hd)->error();
  if (device == kNoDevice || error.code != 0)
    return Error{std::string("its maker's library could not open it (") + (*hd)->error_text(error.code) +
                 "): plug it in again, and close what else uses it."};
  return std::unique_ptr<TouchBus>(new TouchBus(**hd, device));
}

TouchBus::TouchBus(const Library& hd, unsigned device) : hd_(hd), device_(device) {
  hd_.make_current(device_);
  hd_.enable(kForceOutput);
  callback_ = hd_.schedule(&TouchBus::on_frame, this, kDefaultPriority);
  hd_.start_scheduler();
}

TouchBus::~TouchBus() {
  hd_.stop_scheduler();
  hd_.unschedule(callback_);
  hd_.disable_device(device_);
}

unsigned TouchBus::on_frame(void* self) {
  static_cast<TouchBus*>(self)->frame();
  return kCallbackContinues;
}

void TouchBus::frame() {
  DeviceCommand due;
  {
    const std::lock_guard lock(mutex_);
    due = held_command(command_, command_age_);
    command_age_ += kFrame;
  }
  const unsigned calibration = hd_.check_calibration();
  if (calibration == kCalibrationNeedsUpdate) {
    int style = 0;
    hd_.get_integers(kCalibrationStyle, &style);
    hd_.update_calibration(static_cast<unsigned>(style));
  }
  std::array<double, 16> transform{};
  int buttons = 0;
  const std::array<double, 3> force{due.F_H_D.force.x(), due.F_H_D.force.y(), due.F_H_D.force.z()};
  hd_.begin_frame(device_);
  hd_.get_doubles(kTransform, transform.data());
  hd_.get_integers(kButtons, &buttons);
  hd_.set_doubles(kForce, force.data());
  hd_.end_frame(device_);
  const bool lost = is_of_device(hd_.error().code);

  const std::lock_guard lock(mutex_);
  lost_ = lost_ || lost;
  calibrated_ = calibration == kCalibrationGood;
  if (!lost && calibrated_) {
    sample_.X_DH = pose_of(transform);
    sample_.buttons = static_cast<std::uint32_t>(buttons);
    fresh_ = true;
  }
  framed_.notify_one();
}

ForceBus::Turn TouchBus::exchange(const DeviceCommand& command, DeviceSample& sample) {
  std::unique_lock lock(mutex_);
  command_ = command;
  command_age_ = 0;
  framed_.wait_for(lock, kWait, [this] { return fresh_ || lost_; });
  if (lost_) return Turn::lost;
  if (!fresh_) return Turn::none;
  fresh_ = false;
  sample = sample_;
  return Turn::fresh;
}

std::string TouchBus::trouble() const {
  const std::lock_guard lock(mutex_);
  if (calibrated_) return {};
  return "it is not calibrated: put its stylus into the inkwell, or calibrate it in the maker's own set-up.";
}

}  // namespace fulcrum::hd
