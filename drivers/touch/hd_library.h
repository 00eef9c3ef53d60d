#pragma once
// What is used of OpenHaptics' library, libHD, declared as its manual has it. Its frame: x right, y up, z to
// the person; mm and N.

#include "haptics/math/result.h"

namespace fulcrum::hd {

struct ErrorInfo {
  unsigned code = 0;
  int internal = 0;
  unsigned device = 0;
};

using Callback = unsigned (*)(void* data);
inline constexpr unsigned kCallbackContinues = 1;
inline constexpr unsigned kNoDevice = 0xFFFFFFFF;
inline constexpr unsigned short kDefaultPriority = 0x7fff;

// Parameters.
inline constexpr unsigned kButtons = 0x2000, kTransform = 0x2052, kForce = 0x2700, kForceOutput = 0x4000;
// Calibration.
inline constexpr unsigned kCalibrationStyle = 0x2555;
inline constexpr unsigned kCalibrationGood = 0x5000, kCalibrationNeedsUpdate = 0x5001;

// Errors of the device itself: it is not there any more, or does not answer.
inline bool is_of_device(unsigned code) {
  return code >> 8 == 0x03;
}

struct Library {
  unsigned (*init_device)(const char* name);  // null: the first that is there
  void (*disable_device)(unsigned device);
  void (*make_current)(unsigned device);
  void (*enable)(unsigned what);
  void (*start_scheduler)();
  void (*stop_scheduler)();
  unsigned long (*schedule)(Callback, void* data, unsigned short priority);
  void (*unschedule)(unsigned long handle);
  void (*begin_frame)(unsigned device);
  void (*end_frame)(unsigned device);
  void (*get_doubles)(unsigned what, double* values);
  void (*get_integers)(unsigned what, int* values);
  void (*set_doubles)(unsigned what, const double* values);
  ErrorInfo (*error)();
  const char* (*error_text)(unsigned code);
  unsigned (*check_calibration)();
  void (*update_calibration)(unsigned style);
};

// Loaded once. Errors: why there is none, and what would give it.
Result<const Library*> library();

}  // namespace fulcrum::hd
