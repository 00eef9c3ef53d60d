#pragma once
// How long a command takes until a sample shows what it did: bus, board, motors, encoders, the bus again, and
// what waits in between. It is the delay that a stability study counts in ticks.
//
// A handle that slides one way is pushed harder for some milliseconds. Its place x after t is
//     x(t) = c_0 + c_1 t + c_2 t^2 + c_3 I x(t) + c_4 I I x(t) + k H(t - L),    H'' = F, k > 0
// with F what was commanded, each command held until the next, k one over the mass, and I the integral since
// the first t. c_2 is friction, which is constant while it slides, c_3 a damper and c_4 the spring of a hand
// that holds it. L is the latency that leaves the least squares; it is uncertain by as far as their sum grows
// by four of the residual's variances, two standard deviations of a single parameter.

#include <optional>
#include <vector>

namespace fulcrum::app::device_test {

// One push, tick by tick.
struct Kick {
  std::vector<double> time;       // s
  std::vector<double> commanded;  // N, along the push
  std::vector<double> moved;      // m, along the push, as the tick's sample has it
  double began = 0;               // s, when it was pushed harder
};

struct Latency {
  double seconds = 0;
  double uncertainty = 0;  // s
};

// Absent: it slid too short a way, or what it did could as well come from another latency.
std::optional<Latency> latency_of(const Kick& kick);

inline constexpr double kLargestLatency = 0.04;  // s, that is looked for

}  // namespace fulcrum::app::device_test
