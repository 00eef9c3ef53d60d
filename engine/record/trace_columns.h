#pragma once
// The columns of a trace, in one table: the header line, the rows and trace.json are all written from it.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "haptics/world/tick_record.h"

namespace fulcrum::record {

// What one row is made of.
struct TraceRow {
  const TickRecord& record;
  std::int32_t task_step = 0;     // the checkpoint that is next; the number of them once completed
  std::int64_t hard_touches = 0;  // so far
};

using TraceValue = std::variant<double, std::int64_t>;

struct TraceColumn {
  std::string name;     // a tree by '/'
  std::string unit;     // "1" for a count or a ratio
  std::string frame;    // the frame it is expressed in; empty where there is none
  std::string meaning;  // a sentence
  std::function<TraceValue(const TraceRow&)> value;
};

class TraceColumns {
public:
  // What a scene has beyond what every scene has.
  struct Extras {
    bool hard_touches = false;  // the task counts them
    bool torque_substitution = false;
    bool transients = false;  // of torque substitution
    bool impacts = false;
    bool impact_vibration = false;
    bool braking_pulse = false;
    bool vibrotactile_motion = false;
    std::vector<std::string> channels{};  // their names, in the order of VibrotactileCommand::level
    bool holding_point = false;
    bool inertia_compensation = false;
    bool stiffness_levels = false;
  };
  // motors: their names, in the order of TickRecord::actuator_load; empty for a device without motors.
  TraceColumns(double tick_s, std::span<const std::string> motors, Extras extras);
  TraceColumns(double tick_s, std::span<const std::string> motors) : TraceColumns(tick_s, motors, Extras()) {}

  const std::vector<TraceColumn>& columns() const { return columns_; }
  double tick_s() const { return tick_s_; }

  std::string header() const;                                   // the header line, with its end
  void append_row(std::string& to, const TraceRow& row) const;  // one line, with its end
  std::string json() const;                                     // trace.json

private:
  double tick_s_;
  std::vector<TraceColumn> columns_;
};

}  // namespace fulcrum::record
