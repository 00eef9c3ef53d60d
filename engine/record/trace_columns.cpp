#include "engine/record/trace_columns.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "engine/files/number_text.h"
#include "engine/record/whole_rate.h"

namespace fulcrum::record {

namespace {

template <class V>
void describe(V& values, const TraceRow& row) {
  fulcrum::describe(values, row.record);
  values.count(
      {"task/step", "1", "", "The checkpoint that is next, from 0; the number of them once all are done."},
      row.task_step);
  if (row.hard_touches)
    values.count({"task/hard_touches", "1", "", "Touches so far that were harder than the task allows."},
                 *row.hard_touches);
}

// Visitor: the columns, without their values.
class ColumnLister {
public:
  explicit ColumnLister(const RecordNames& names) : names_(names) {}

  void time(const Quantity& what, std::int64_t) { add(what); }
  void number(const Quantity& what, double) { add(what); }
  void count(const Quantity& what, std::int64_t) { add(what); }
  void length(const Quantity& what, const Vec3&) { add(what); }
  void vector(const Quantity& what, const Vec3&) {
    for (const char* axis : {"/x", "/y", "/z"}) add(what, axis);
  }
  void pose(const Quantity& what, const Pose&) {
    for (const char* part : {"/p/x", "/p/y", "/p/z"}) add(what, part, "m", ": position.");
    for (const char* part : {"/q/w", "/q/x", "/q/y", "/q/z"})
      add(what, part, "1", ": orientation, unit quaternion.");
  }
  void wrench(const Quantity& what, const Wrench&) {
    for (const char* part : {"/force/x", "/force/y", "/force/z"}) add(what, part, "N", ": force.");
    for (const char* part : {"/torque/x", "/torque/y", "/torque/z"}) add(what, part, "N m", ": torque.");
  }
  void each(const Quantity& what, std::span<const double> all, std::span<const std::string> names) {
    for (const std::string& name : names.first(std::min(names.size(), all.size()))) add(what, '/' + name);
  }
  void unseen(const auto&) {}
  const RecordNames& names() const { return names_; }

  std::vector<TraceColumn> take() { return std::move(columns_); }

private:
  // unit and what is added to the meaning: those of the quantity itself, unless there are others.
  void add(const Quantity& what, std::string_view part = "", std::string_view unit = "",
           std::string_view kind = "") {
    columns_.push_back({std::string(what.name).append(part), std::string(unit.empty() ? what.unit : unit),
                        std::string(what.frame), std::string(what.meaning).append(kind)});
  }

  const RecordNames& names_;
  std::vector<TraceColumn> columns_;
};

// Visitor: the values of the same columns in the same order, each followed by a comma.
class RowWriter {
public:
  RowWriter(std::string& to, double tick_s, const RecordNames& names)
      : to_(to), tick_s_(tick_s), names_(names) {}

  void time(const Quantity&, std::int64_t tick) {
    const auto ticks = static_cast<double>(tick);
    const std::optional<double> rate = whole_rate(tick_s_);
    add(rate ? ticks / *rate : ticks * tick_s_);
  }
  void number(const Quantity&, double value) { add(value); }
  void count(const Quantity&, std::int64_t value) { add(value); }
  void length(const Quantity&, const Vec3& v) { add(v.norm()); }
  void vector(const Quantity&, const Vec3& v) { add(v); }
  void pose(const Quantity&, const Pose& X) {
    add(X.p);
    add(X.q.w());
    add(Vec3(X.q.vec()));
  }
  void wrench(const Quantity&, const Wrench& F) {
    add(F.force);
    add(F.torque);
  }
  void each(const Quantity&, std::span<const double> all, std::span<const std::string> names) {
    for (const double value : all.first(std::min(names.size(), all.size()))) add(value);
  }
  void unseen(const auto&) {}
  const RecordNames& names() const { return names_; }

private:
  void add(auto value) {
    append_number(to_, value);
    to_ += ',';
  }
  void add(const Vec3& v) {
    for (const double component : v) add(component);
  }

  std::string& to_;
  double tick_s_;
  const RecordNames& names_;
};

}  // namespace

TraceColumns::TraceColumns(double tick_s, RecordNames names, const TraceRow& like)
    : tick_s_(tick_s), names_(std::move(names)) {
  ColumnLister lister(names_);
  describe(lister, like);
  columns_ = lister.take();
}

std::string TraceColumns::header() const {
  std::string line;
  for (const TraceColumn& column : columns_) {
    line += column.name;
    line += ',';
  }
  line.back() = '\n';
  return line;
}

void TraceColumns::append_row(std::string& to, const TraceRow& row) const {
  RowWriter writer(to, tick_s_, names_);
  describe(writer, row);
  to.back() = '\n';
}

std::string TraceColumns::json() const {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const TraceColumn& column : columns_) {
    columns.push_back({{"name", column.name},
                       {"unit", column.unit},
                       {"frame", column.frame.empty() ? nullptr : nlohmann::ordered_json(column.frame)},
                       {"meaning", column.meaning}});
  }
  const nlohmann::ordered_json document = {
      {"version", kTraceVersion}, {"tick_s", tick_s_}, {"columns", columns}};
  return document.dump(2) + '\n';
}

}  // namespace fulcrum::record
