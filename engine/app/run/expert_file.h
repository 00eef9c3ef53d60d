#pragma once
// The expert's run as text, to be kept in the cache. A file there may have been written by anyone: what is no
// such run, or none that a run of this task can have come to, is no run.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/app/run/expert_run.h"

namespace fulcrum::app {

// Counts up with every change of what the text says.
inline constexpr int kExpertFileVersion = 2;
inline constexpr std::uint64_t kMostExpertBytes = 1 << 19;

// key: of all that the run depends on.
std::string expert_text(const ExpertRun& run, const std::string& key);

// None: another version, another key, damaged, or implausible for a task of so many checkpoints that takes at
// most limit_s.
std::optional<ExpertRun> read_expert(std::string_view text, const std::string& key, std::size_t checkpoints,
                                     double limit_s);

}  // namespace fulcrum::app
