#pragma once
// What the libraries that Fulcrum is compared with cost, and where their depths err.

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/contact_workload.h"

namespace fulcrum::bench {

struct PeerCost {
  double median_us, p99_us;
  double contacts;             // mean
  double depth_error_percent;  // the deepest contact against the truth, as DepthError::percent
};

struct PeerResult {
  std::string key, name, package;
  std::optional<PeerCost> cost;  // none: the library is not there
};

std::vector<PeerResult> cost_of_peers(const Workload& workload, const std::vector<Pose>& poses);

}  // namespace fulcrum::bench
