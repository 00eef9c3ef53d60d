#pragma once
// What a person has done in one attempt at a scenario, as a learning record store is told of it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::session {

struct Statement {
  std::string uuid{};          // its own, for good: a store knows by it what it has already
  std::string participant{};   // a pseudonym
  std::string session_uuid{};  // what the attempts of one session share
  std::string scenario{};
  std::string scenario_title{};  // empty: the scenario's name is its title
  std::string ended_utc{};       // ISO 8601, as 2026-03-04T05:06:07.089Z
  double duration_s = 0;
  bool completed = false;
  std::optional<double> score{};  // 0 to 100
  std::vector<std::pair<std::string, double>> metrics{};
  std::string program_version{};
  std::string device{};
  std::string hand{};  // of the simulated device; empty: a person's
  bool left_handed = false;
};

}  // namespace fulcrum::session
