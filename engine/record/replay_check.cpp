#include "engine/record/replay_check.h"

#include <span>
#include <string_view>
#include <vector>

#include "engine/record/digest.h"
#include "engine/record/trace_reader.h"

namespace fulcrum::record {

namespace {

// ": COLUMN was A and is B", or why that cannot be said.
std::string differing_column(const TraceColumns& columns, std::span<const std::string_view> now,
                             std::int64_t row, const std::filesystem::path& original_trace) {
  const std::string unknown = "; the run's trace, " + original_trace.string() + ", ";
  Result<TraceReader> trace = TraceReader::open(original_trace);
  if (!trace) return unknown + "which would say in what, cannot be read.";
  for (std::int64_t i = 0; i <= row; ++i)
    if (!trace->next()) return unknown + "which would say in what, ends before that tick.";
  for (std::size_t i = 0; i < columns.columns().size(); ++i) {
    const std::string& name = columns.columns()[i].name;
    const std::optional<std::size_t> then = trace->column(name);
    if (then && *then < trace->cells().size() && trace->cells()[*then] != now[i]) {
      return ": " + name + " was " + std::string(trace->cells()[*then]) + " and is " + std::string(now[i]) +
             '.';
    }
  }
  return ", in a value that the trace does not show.";
}

}  // namespace

void ReplayCheck::tick(const TraceRow& replayed, std::optional<std::uint64_t> recorded_digest) {
  compared_ += recorded_digest.has_value();
  if (!first_ && recorded_digest && digest(replayed.record) != *recorded_digest)
    first_ = Difference{ticks_, replayed.record, replayed.task_step, replayed.hard_touches};
  ++ticks_;
}

std::string ReplayCheck::divergence(const TraceColumns& columns,
                                    const std::filesystem::path& original_trace) const {
  const TraceRow replayed{first_->replayed, first_->task_step, first_->hard_touches};
  std::string line;
  columns.append_row(line, replayed);
  const std::vector<std::string_view> cells = split_cells(line);
  return "The replay differs from the run from tick " + std::to_string(first_->replayed.tick) + " on (" +
         std::string(cells.front()) + " s)" + differing_column(columns, cells, first_->row, original_trace);
}

}  // namespace fulcrum::record
