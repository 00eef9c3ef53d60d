// OpenHaptics' library as its manual has it, for one Touch that a test holds: its scheduler is a thread that
// calls back, a thousand times a second as near as the machine can; what is set between two frames reaches
// the motors at the end of the frame, if forces are enabled.

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/drivers_vendor/stand_in.h"

struct HDErrorInfo {
  unsigned code;
  int internal;
  unsigned device;
};

namespace {

using Callback = unsigned (*)(void*);
constexpr unsigned kCommError = 0x0302, kIllegalEnd = 0x0401, kNone = 0xFFFFFFFF;

fulcrum::stand_in::Handle handle;
std::mutex scheduling;
Callback callback = nullptr;
void* callback_data = nullptr;
std::atomic<bool> running{false};
std::thread servo;
bool in_frame = false;
double asked[3] = {0, 0, 0};
HDErrorInfo pending{};

void fail(unsigned code) {
  if (pending.code == 0) pending.code = code;
}

}  // namespace

extern "C" {

fulcrum::stand_in::Handle* stand_in_handle() {
  return &handle;
}

unsigned hdInitDevice(const char* /*name*/) {
  const std::lock_guard lock(handle.mutex);
  if (!handle.there) {
    fail(kCommError);
    return kNone;
  }
  ++handle.opened;
  return 0;
}

void hdDisableDevice(unsigned /*device*/) {
  const std::lock_guard lock(handle.mutex);
  handle.powered = false;
  for (double& f : handle.force) f = 0;
  ++handle.closed;
}

void hdMakeCurrentDevice(unsigned /*device*/) {}

void hdEnable(unsigned what) {
  const std::lock_guard lock(handle.mutex);
  if (what == 0x4000) handle.powered = true;
}

unsigned long hdScheduleAsynchronous(Callback function, void* data, unsigned short /*priority*/) {
  const std::lock_guard lock(scheduling);
  callback = function;
  callback_data = data;
  return 7;
}

void hdUnschedule(unsigned long /*handle*/) {
  const std::lock_guard lock(scheduling);
  callback = nullptr;
}

void hdStartScheduler() {
  running = true;
  servo = std::thread([] {
    auto due = std::chrono::steady_clock::now();
    while (running) {
      due += std::chrono::milliseconds(1);
      std::this_thread::sleep_until(due);
      const std::lock_guard lock(scheduling);
      if (callback != nullptr && callback(callback_data) == 0) callback = nullptr;
    }
  });
}

void hdStopScheduler() {
  running = false;
  if (servo.joinable()) servo.join();
}

void hdBeginFrame(unsigned /*device*/) {
  const std::lock_guard lock(handle.mutex);
  if (!handle.there) fail(kCommError);
  in_frame = true;
}

void hdEndFrame(unsigned /*device*/) {
  const std::lock_guard lock(handle.mutex);
  if (!in_frame) fail(kIllegalEnd);
  if (!handle.there) fail(kCommError);
  in_frame = false;
  for (int i = 0; i < 3; ++i) handle.force[i] = handle.powered && handle.there ? asked[i] : 0;
  ++handle.turns;
}

void hdGetDoublev(unsigned what, double* values) {
  const std::lock_guard lock(handle.mutex);
  if (what != 0x2052) return;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) values[4 * column + row] = handle.turn[row][column];
    values[12 + row] = handle.p[row];
    values[4 * row + 3] = 0;
  }
  values[15] = 1;
}

void hdGetIntegerv(unsigned what, int* values) {
  const std::lock_guard lock(handle.mutex);
  if (what == 0x2000) *values = handle.buttons;
  if (what == 0x2555) *values = 4;  // by its inkwell
}

void hdSetDoublev(unsigned what, const double* values) {
  const std::lock_guard lock(handle.mutex);
  if (what != 0x2700) return;
  for (int i = 0; i < 3; ++i) asked[i] = values[i];
}

HDErrorInfo hdGetError() {
  const std::lock_guard lock(handle.mutex);
  const HDErrorInfo error = pending;
  pending = {};
  return error;
}

const char* hdGetErrorString(unsigned code) {
  return code == kCommError ? "communication error" : "no error";
}

unsigned hdCheckCalibration() {
  const std::lock_guard lock(handle.mutex);
  return handle.calibrated ? 0x5000 : 0x5002;
}

void hdUpdateCalibration(unsigned /*style*/) {}

}  // extern "C"
