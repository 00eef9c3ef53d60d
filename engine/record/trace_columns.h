#pragma once
// The columns of a trace: the header line, the rows and trace.json are all written from the descriptions that
// stand beside the structs of a record (haptics/signal/quantity.h).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/signal/quantity.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::record {

// Of trace.json. Version 1 had other names for the effects' columns, and another order.
inline constexpr int kTraceVersion = 2;

// What one row is made of.
struct TraceRow {
  const TickRecord& record;
  std::int32_t task_step = 0;  // the checkpoint that is next; the number of them once completed
  std::optional<std::int64_t> hard_touches{};  // so far; none: the task does not count them
};

struct TraceColumn {
  std::string name;     // a tree by '/'
  std::string unit;     // "1" for a count or a ratio
  std::string frame;    // the frame it is expressed in; empty where there is none
  std::string meaning;  // a sentence
};

class TraceColumns {
public:
  // like: a row that has what every row of this trace will have. Its values do not matter.
  TraceColumns(double tick_s, RecordNames names, const TraceRow& like);

  const std::vector<TraceColumn>& columns() const { return columns_; }
  double tick_s() const { return tick_s_; }

  std::string header() const;                                   // the header line, with its end
  void append_row(std::string& to, const TraceRow& row) const;  // one line, with its end
  std::string json() const;                                     // trace.json

private:
  double tick_s_;
  RecordNames names_;
  std::vector<TraceColumn> columns_;
};

}  // namespace fulcrum::record
