#pragma once
// Compares a replay with the run it repeats, and finds where they part.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/record/trace_columns.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::record {

class ReplayCheck {
public:
  // Call for every entry of the tape in order.
  void tick(const TraceRow& replayed, std::optional<std::uint64_t> recorded_digest);

  bool same() const { return !first_; }
  std::int64_t ticks() const { return ticks_; }
  std::int64_t compared() const { return compared_; }  // of them, those that the tape has a digest of

  // The first tick that differs and, if the original's trace is there, which column: a sentence. Only if
  // !same().
  std::string divergence(const TraceColumns& columns, const std::filesystem::path& original_trace) const;

private:
  struct Difference {
    std::int64_t row = 0;  // counted from 0, in the tape and in the trace
    TickRecord replayed;
    std::int32_t task_step = 0;
    std::optional<std::int64_t> hard_touches{};
  };

  std::int64_t ticks_ = 0;
  std::int64_t compared_ = 0;
  std::optional<Difference> first_;
};

}  // namespace fulcrum::record
