#pragma once
// What a calibration keeps of a device, measured on the bench of the device test.

#include <array>
#include <optional>

#include "engine/app/device_test/findings.h"
#include "engine/app/device_test/person.h"
#include "engine/app/device_test/test_bench.h"
#include "engine/scenario/calibration.h"

namespace fulcrum::app::device_test {

// All of it: where a hand reaches, what the handle weighs, and which hand holds it. What was not measured
// keeps what `calibration` says of it. Ends early where the bench is over.
Findings calibrate(TestBench& bench, Person& person, scenario::Calibration& calibration);

// How the handle, held up by a soft servo and led slowly up and down, was held up. Where it goes up, the
// motors push by its weight and its friction, where it goes down by its weight less its friction:
//     weight = (up + down) / 2     friction = (up - down) / 2
// The mean over the later part of each way is taken, where the handle follows at an even pace; three ways up
// and down, and the spread of their weights. A push that changes along that part is not the handle's weight
// and friction alone: it met something.
struct Weighing {
  double weight = 0;    // N; below 0: it is pushed up by itself
  double friction = 0;  // N
  double spread = 0;    // N, the largest difference between two of them
  double uneven = 0;    // N, the largest difference between the halves of a way's later part
  double moved = 0;     // m, that the handle went up and down, in the mean
  double most = 0;      // N, that the motors pushed up or down
  // It did not follow: farther from where it was led than kAstray, faster than kRuns, or with all that the
  // bench pushes for longer than kPressed. The force went then; the other figures say nothing.
  bool astray = false;
};
// Absent: the bench was over before it was through.
std::optional<Weighing> weigh(TestBench& bench);

inline constexpr double kWeighingWay = 0.02;  // m, that it is led up and down
inline constexpr double kAstray = 0.03;       // m
inline constexpr double kRuns = 0.25;         // m/s
inline constexpr double kPressed = 0.3;       // s

}  // namespace fulcrum::app::device_test
