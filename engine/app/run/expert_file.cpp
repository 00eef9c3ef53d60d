#include "engine/app/run/expert_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace fulcrum::app {
namespace {

using nlohmann::json;

constexpr int kDeepest = 3;             // the numbers of a pose, in the way, in the document
constexpr std::size_t kPoseSize = 8;    // time, position, quaternion
constexpr double kMostFigure = 1e6;     // in any unit
constexpr double kFarthest = 1e3;       // m, from the scene's origin
constexpr double kUnit = 1e-6;          // by which a quaternion may be off
constexpr double kTimeRounding = 1e-6;  // s

// Null: what is nested deeper than a run is not kept, so that no depth of nesting costs a stack.
json shallow(std::string_view text) {
  bool deep = false;
  json document = json::parse(
      text,
      [&deep](int depth, json::parse_event_t, const json&) {
        deep = deep || depth > kDeepest;
        return depth <= kDeepest;
      },
      false);
  return deep ? json() : document;
}

std::optional<double> number(const json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

const json* array_in(const json& document, const char* name) {
  const auto found = document.find(name);
  return found != document.end() && found->is_array() ? &*found : nullptr;
}

// Exactly those that a run writes: no other name, none missing, no fraction of a count.
std::optional<session::TrialMetrics> read_figures(const json& document) {
  const auto figures = document.find("figures");
  if (figures == document.end() || !figures->is_object()) return std::nullopt;
  std::vector<std::pair<std::string, double>> values;
  for (const auto& [name, value] : figures->items()) {
    const std::optional<double> figure = number(value);
    if (!figure) return std::nullopt;
    values.emplace_back(name, *figure);
  }
  const session::TrialMetrics metrics = session::from_named_values(values);
  const auto named = named_values(metrics);
  const std::map<std::string, double> told(values.begin(), values.end()), kept(named.begin(), named.end());
  if (told != kept) return std::nullopt;
  return metrics;
}

bool plausible(const session::TrialMetrics& metrics, std::size_t checkpoints, double limit_s) {
  for (const auto& [name, value] : named_values(metrics))
    if (!(std::abs(value) <= kMostFigure) || (value < 0 && name != "smoothness")) return false;
  return metrics.time <= limit_s + kTimeRounding && std::cmp_equal(metrics.checkpoints, checkpoints) &&
         metrics.checkpoints_reached <= metrics.checkpoints &&
         metrics.completed == (metrics.checkpoints_reached == metrics.checkpoints) &&
         metrics.contact_time <= metrics.time + kTimeRounding &&
         metrics.hard_touch_time <= metrics.time + kTimeRounding &&
         metrics.force_mean <= metrics.force_peak * (1 + kUnit) && metrics.force_95 <= metrics.force_peak;
}

// One after the other, as many as the figures say, and then none.
bool read_reached(const json& document, ExpertRun& run) {
  const json* times = array_in(document, "reached_s");
  if (times == nullptr || !std::cmp_equal(times->size(), run.metrics.checkpoints)) return false;
  double before = 0;
  for (const json& value : *times) {
    const bool counts = std::cmp_less(run.reached.size(), run.metrics.checkpoints_reached);
    run.reached.push_back(number(value));
    if (run.reached.back().has_value() != counts || (!counts && !value.is_null())) return false;
    if (!counts) continue;
    const double time = *run.reached.back();
    if (!(time >= before && time <= run.metrics.time + kTimeRounding)) return false;
    before = time;
  }
  return true;
}

std::optional<ToolFilm::Frame> read_frame(const json& value) {
  if (!value.is_array() || value.size() != kPoseSize) return std::nullopt;
  double figure[kPoseSize];
  for (std::size_t i = 0; i < kPoseSize; ++i) {
    const std::optional<double> read = number(value[i]);
    if (!read || !std::isfinite(*read)) return std::nullopt;
    figure[i] = *read;
  }
  ToolFilm::Frame frame{
      figure[0], {Quat(figure[4], figure[5], figure[6], figure[7]), {figure[1], figure[2], figure[3]}}};
  if (!(frame.shown.p.norm() <= kFarthest) || !(std::abs(frame.shown.q.norm() - 1) <= kUnit))
    return std::nullopt;
  return frame;
}

bool read_way(const json& document, ExpertRun& run) {
  const json* frames = array_in(document, "way");
  if (frames == nullptr || frames->empty() || frames->size() > ToolFilm::kMost) return false;
  for (const json& value : *frames) {
    const std::optional<ToolFilm::Frame> frame = read_frame(value);
    if (!frame || frame->time < 0 || frame->time > run.metrics.time + kTimeRounding) return false;
    if (!run.way.empty() && !(frame->time > run.way.back().time)) return false;
    run.way.push_back(*frame);
  }
  return true;
}

}  // namespace

std::string expert_text(const ExpertRun& run, const std::string& key) {
  json figures = json::object(), reached = json::array(), way = json::array();
  for (const auto& [name, value] : named_values(run.metrics)) figures[name] = value;
  for (const std::optional<double>& time : run.reached) reached.push_back(time ? json(*time) : json());
  for (const ToolFilm::Frame& frame : run.way) {
    const auto& [q, p] = frame.shown;
    way.push_back({frame.time, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
  }
  const json document = {{"version", kExpertFileVersion},
                         {"key", key},
                         {"figures", figures},
                         {"reached_s", reached},
                         {"way", way}};
  return document.dump() + '\n';
}

std::optional<ExpertRun> read_expert(std::string_view text, const std::string& key, std::size_t checkpoints,
                                     double limit_s) {
  const json document = shallow(text);
  if (!document.is_object()) return std::nullopt;
  if (document.value("version", json()) != kExpertFileVersion || document.value("key", json()) != key)
    return std::nullopt;
  const std::optional<session::TrialMetrics> metrics = read_figures(document);
  if (!metrics || !plausible(*metrics, checkpoints, limit_s)) return std::nullopt;
  ExpertRun run{*metrics, {}, {}};
  if (!read_reached(document, run) || !read_way(document, run)) return std::nullopt;
  return run;
}

}  // namespace fulcrum::app
