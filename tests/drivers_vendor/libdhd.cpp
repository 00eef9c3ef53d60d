// Force Dimension's library as its manual has it, for one omega.6 that a test holds: calls fail unless it is
// open, and forces do nothing unless they are enabled.

#include "tests/drivers_vendor/stand_in.h"

namespace {

fulcrum::stand_in::Handle handle;
bool open_now = false;
const char* last = "no error";

int failed(const char* why) {
  last = why;
  return -1;
}
bool answers(char device) {
  return open_now && device == 0 && handle.there;
}

}  // namespace

extern "C" {

fulcrum::stand_in::Handle* stand_in_handle() {
  return &handle;
}

int dhdGetDeviceCount() {
  const std::lock_guard lock(handle.mutex);
  return handle.there ? 1 : 0;
}

int dhdOpen() {
  const std::lock_guard lock(handle.mutex);
  if (!handle.there) return failed("no device found");
  if (open_now) return failed("device already in use");
  open_now = true;
  ++handle.opened;
  return 0;
}

int dhdClose(char device) {
  const std::lock_guard lock(handle.mutex);
  if (!open_now || device != 0) return failed("device not open");
  open_now = handle.powered = false;
  ++handle.closed;
  return 0;
}

int dhdEnableForce(unsigned char on, char device) {
  const std::lock_guard lock(handle.mutex);
  if (!answers(device)) return failed("communication error");
  handle.powered = on != 0;
  return 0;
}

int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double turn[3][3], char device) {
  const std::lock_guard lock(handle.mutex);
  if (!answers(device)) return failed("communication error");
  *x = handle.p[0];
  *y = handle.p[1];
  *z = handle.p[2];
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) turn[row][column] = handle.turn[row][column];
  ++handle.turns;
  return 0;
}

int dhdSetForceAndTorque(double fx, double fy, double fz, double tx, double ty, double tz, char device) {
  const std::lock_guard lock(handle.mutex);
  if (!answers(device)) return failed("communication error");
  const double force[3] = {fx, fy, fz}, torque[3] = {tx, ty, tz};
  for (int i = 0; i < 3; ++i) {
    handle.force[i] = handle.powered ? force[i] : 0;
    handle.torque[i] = handle.powered ? torque[i] : 0;
  }
  return 0;
}

int dhdGetButton(int number, char device) {
  const std::lock_guard lock(handle.mutex);
  if (!answers(device)) return failed("communication error");
  return handle.buttons >> number & 1;
}

int dhdGetStatus(int words[], char device) {
  const std::lock_guard lock(handle.mutex);
  if (!answers(device)) return failed("communication error");
  for (int i = 0; i < 16; ++i) words[i] = 0;
  words[0] = words[1] = 1;
  words[3] = handle.calibrated ? 1 : 0;
  return 0;
}

const char* dhdErrorGetLastStr() {
  return last;
}

}  // extern "C"
