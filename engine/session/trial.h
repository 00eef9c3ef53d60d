#pragma once
// A finished trial, as results keep it.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/session/trial_meter.h"
#include "engine/session/trial_metrics.h"

namespace fulcrum::session {

struct Trial {
  std::string uuid;
  std::string scenario, title;  // as it was asked for; what the scenario calls itself
  std::string began, ended;     // UTC, 2026-11-25T09:03:00.000Z
  std::string device, hand;     // hand: of the simulated device; empty: a person's
  bool left_handed = false;
  std::int64_t seed = 1;
  // It came to its own end: completed, or its time was up. Otherwise the person left, or a fault ended it.
  bool whole = false;
  TrialMetrics metrics;
  std::vector<TrialEvent> events;
  std::optional<double> score{};  // 0 to 100
  std::string changes{};          // of the task, as --set made them: KEY=VALUE, a space between; empty: none
  std::string folder;             // absolute: where trace, tape and report lie
  std::string trace_sha256;       // of trace.csv there; empty: none was written
};

// What belongs together: one start of the program.
struct Session {
  std::string uuid;
  std::string participant;  // a pseudonym
  std::string began;        // UTC
  std::string program_version;
};

}  // namespace fulcrum::session
