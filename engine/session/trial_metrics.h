#pragma once
// What a trial came to, as figures that are the same for everyone who reads them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::session {

struct TrialMetrics {
  double time = 0;  // s, of the trial: it rests while the force is stopped
  bool completed = false;
  bool guided = false;  // the person was led, be it for a tick: the other figures are not theirs alone
  std::int64_t checkpoints_reached = 0, checkpoints = 0;        // that have to be
  std::int64_t optional_reached = 0, optional_checkpoints = 0;  // that need not be
  double path = 0;                                              // m, that the touch point went
  std::optional<double> smoothness{};   // spectral arc length of the touch point's speed
  double contact_time = 0;              // s, in which the scene pushed the tool
  double force_mean = 0, force_95 = 0;  // N, of the scene on the tool, over that time: mean, 95th percentile
  double force_peak = 0;                // N
  double depth_peak = 0;                // m, as ticks saw it
  std::int64_t touches_on_the_way = 0;  // that began while the touch point was not at the next checkpoint
  std::optional<std::int64_t> hard_touches{};  // none: the task does not count them
  double hard_touch_time = 0;                  // s, over the limit
  std::optional<std::int64_t> slips{};         // off lines and out of bores; none: the task has none
  std::optional<std::int64_t> trespasses{};    // into what is to be avoided; none: the task has none
  double trespass_time = 0;                    // s, in it
  double torque_error = 0;                     // E_tau (N m s), of the coupling on the tool
  double force_error = 0;                      // E_F (N s), of contact
};

// By the names under which results keep them, which end in their units; what is not known is left out.
std::vector<std::pair<std::string, double>> named_values(const TrialMetrics& metrics);

// The names that there may be, in the same order.
const std::vector<std::string_view>& metric_names();

// From such values; what is missing keeps its default. What is no count, or is no number, is left out.
TrialMetrics from_named_values(const std::vector<std::pair<std::string, double>>& values);

}  // namespace fulcrum::session
