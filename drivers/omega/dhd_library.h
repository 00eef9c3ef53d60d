#pragma once
// What is used of Force Dimension's library, libdhd, declared as its manual has it. Its frame: x to the
// person, y right, z up; m and N.

#include "haptics/math/result.h"

namespace fulcrum::dhd {

inline constexpr int kStatusWords = 32;  // more than any version writes
inline constexpr int kStatusPower = 0, kStatusCalibrated = 3;

struct Library {
  int (*device_count)();
  int (*open)();  // the device's number, below 0 where there is none
  int (*close)(char device);
  int (*enable_force)(unsigned char on, char device);
  // Below 0: it failed.
  int (*frame)(double* x, double* y, double* z, double turn[3][3], char device);
  int (*set_force)(double fx, double fy, double fz, double tx, double ty, double tz, char device);
  int (*button)(int number, char device);  // above 0: it is down
  int (*status)(int words[], char device);
  const char* (*last_error)();
};

// Loaded once. Errors: why there is none, and what would give it.
Result<const Library*> library();

}  // namespace fulcrum::dhd
