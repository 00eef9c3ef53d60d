#pragma once
// Variants of torque substitution over the same trials: what each came to, and how they differ in pairs.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/report/page.h"
#include "haptics/device/yielding.h"

namespace fulcrum::analysis::compare {

// What the figures are of. E_tau is the integral over the run of the coupling's torque on the tool, E_F that
// of the force of contact on it, without its weight; t_c is when the last checkpoint counted.
enum class Metric { torque_error, force_error, completion_time };
inline constexpr std::array kMetrics{Metric::torque_error, Metric::force_error, Metric::completion_time};

struct MetricName {
  const char* csv;     // E_tau
  const char* symbol;  // with Greek letters, for a page
  const char* title;
  const char* unit;
};
MetricName name_of(Metric metric);

struct Trial {
  std::int64_t seed = 0;
  double torque_error_Nms = 0;
  double force_error_Ns = 0;
  std::optional<double> completion_time_s;  // absent: it did not complete
  std::string fault;                        // that stopped the force and ended it; empty: none did

  std::optional<double> value(Metric metric) const;
};

// Of one trial, every so many ticks.
struct TimePoint {
  double time = 0;       // s
  double torque = 0;     // N m, |tau_v|
  bool bad = false;      // in any tick since the time point before
  double vibration = 0;  // N, amplitude
  double ghost = 0;      // opacity
};

struct VariantRuns {
  std::string name;
  std::vector<Trial> trials;      // in the same order for every variant
  std::vector<TimePoint> course;  // of the first trial
};

struct Comparison {
  std::string scenario, title;  // as it is called; as people read it
  std::string command;          // that makes it again
  std::string device;
  std::string hand;  // its name; empty: the motion comes from `tape`
  std::optional<YieldingDesc> yields;
  std::string tape;
  double time_limit_s = 0;
  double bad_above_Nm = 0;
  report::Facts built;                // what of the effect is, and its figures
  std::vector<VariantRuns> variants;  // the first is what the others are compared with
};

struct Interval {
  double low = 0, high = 0;
};

// By Student's t, for values that are normally distributed.
inline constexpr double kConfidence = 0.95;
struct Estimate {
  std::size_t n = 0;
  double mean = 0;                   // meaningless without values
  std::optional<Interval> interval;  // of the mean; absent below two values
};
Estimate estimate(std::span<const double> values);

Estimate estimate_of(const VariantRuns& runs, Metric metric);

// Of runs - reference, trial by trial, over the trials in which both have a value.
Estimate difference_of(const VariantRuns& runs, const VariantRuns& reference, Metric metric);

// Both have intervals, and no value lies in both.
bool apart(const Estimate& a, const Estimate& b);

}  // namespace fulcrum::analysis::compare
