#include "engine/record/summary.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "engine/files/block_file.h"
#include "engine/record/run_folder.h"

namespace fulcrum::record {

namespace {

constexpr int kSummaryVersion = 2;

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json checkpoints_json(const std::vector<CheckpointResult>& checkpoints) {
  Json list = Json::array();
  for (const CheckpointResult& checkpoint : checkpoints)
    list.push_back({{"name", checkpoint.name}, {"reached_s", or_null(checkpoint.reached_s)}});
  return list;
}

Json tick_cpu_json(const std::optional<TickCpu>& cpu) {
  return cpu ? Json{{"p50", cpu->p50}, {"p99", cpu->p99}, {"p999", cpu->p999}, {"max", cpu->max}} : Json();
}

Json faults_json(const std::vector<FaultCount>& faults) {
  Json list = Json::array();
  for (const FaultCount& fault : faults) {
    list.push_back({{"name", fault.name},
                    {"first_tick", fault.first_tick},
                    {"ticks", fault.ticks},
                    {"sentence", fault.sentence}});
  }
  return list;
}

Json latency_json(const SoundLatency& latency) {
  return {{"mean", latency.mean_ms}, {"max", latency.max_ms}};
}

Json hand_to_pixel_json(const HandToPixel& figures) {
  Json stages = {{"frames", figures.frames}};
  for (std::size_t i = 0; i < kStageNames.size(); ++i) {
    const StageFigures& stage = figures.stages[i];
    stages[std::string(kStageNames[i])] = {
        {"p50", stage.p50_ms}, {"p99", stage.p99_ms}, {"max", stage.max_ms}};
  }
  return stages;
}

Json colocation_json(const Colocated& colocation) {
  return {{"space", colocation.space},
          {"residual_m", colocation.residual_m},
          {"residuals_m", colocation.residuals_m}};
}

Json heard_json(const HeardScene& heard) {
  return {
      {"device", heard.device},       {"blows", heard.blows},
      {"dropped", heard.dropped},     {"late", heard.late},
      {"unplugged", heard.unplugged}, {"latency_ms", heard.latency ? latency_json(*heard.latency) : Json()}};
}

Json limits_json(const std::vector<FaultCount>& limits) {
  Json list = Json::array();
  for (const FaultCount& limit : limits) list.push_back({{"name", limit.name}, {"ticks", limit.ticks}});
  return list;
}

}  // namespace

void Summary::take(const RunTotals& totals) {
  ticks = totals.ticks();
  torque_error_Nms = totals.torque_error_Nms();
  force_error_Ns = totals.force_error_Ns();
  force_error_rendered_Ns = totals.force_error_rendered_Ns();
  peak_force_N = totals.peak_force_N();
  peak_force_rendered_N = totals.peak_force_rendered_N();
  peak_torque_Nm = totals.peak_torque_Nm();
  peak_torque_rendered_Nm = totals.peak_torque_rendered_Nm();
  faults = totals.faults();
  limits = totals.limits();
}

std::string heard_text(const HeardScene& heard) {
  const auto count = [](std::int64_t n, const char* one) {
    return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
  };
  std::string text = count(heard.blows, "blow") + " on " + heard.device;
  if (heard.latency) {
    char figures[96];
    std::snprintf(figures, sizeof figures, ": %.0f ms from a blow to the loudspeaker, at most %.0f ms",
                  heard.latency->mean_ms, heard.latency->max_ms);
    text += figures;
  }
  if (heard.dropped > 0) text += "; " + std::to_string(heard.dropped) + " made room for stronger ones";
  if (heard.unplugged) text += "; then the device was unplugged";
  if (heard.late > 0) text += "; " + std::to_string(heard.late) + " came too late to be heard";
  return text;
}

std::string summary_json(const Summary& summary) {
  Json document = {{"version", kSummaryVersion},
                   {"scenario", summary.scenario},
                   {"device", summary.device},
                   {"hand", summary.hand},
                   {"seed", summary.seed},
                   {"ticks", summary.ticks},
                   {"tick_s", summary.tick_s},
                   {"completed", summary.completed},
                   {"checkpoints", checkpoints_json(summary.checkpoints)},
                   {"completion_time_s", or_null(summary.completion_time_s)},
                   {"torque_error_Nms", summary.torque_error_Nms},
                   {"force_error_Ns", summary.force_error_Ns},
                   {"force_error_rendered_Ns", summary.force_error_rendered_Ns},
                   {"peak_force_N", summary.peak_force_N},
                   {"peak_force_rendered_N", summary.peak_force_rendered_N},
                   {"peak_torque_Nm", summary.peak_torque_Nm},
                   {"peak_torque_rendered_Nm", summary.peak_torque_rendered_Nm},
                   {"max_penetration_m", or_null(summary.max_penetration_m)},
                   {"max_penetration_within_m", or_null(summary.max_penetration_within_m)},
                   {"max_penetration_at_s", or_null(summary.max_penetration_at_s)},
                   {"max_penetration_part", or_null(summary.max_penetration_part)},
                   {"tick_cpu_us", tick_cpu_json(summary.tick_cpu_us)},
                   {"late_ticks", summary.late_ticks},
                   {"lost_ticks", summary.lost_ticks},
                   {"faults", faults_json(summary.faults)},
                   {"limits", limits_json(summary.limits)},
                   {"built", summary.built},
                   {"left_out", summary.left_out},
                   {"trace_sha256", or_null(summary.trace_sha256)}};
  if (summary.hard_touches) {
    document["hard_touches"] = summary.hard_touches->count;
    document["hard_touch_s"] = summary.hard_touches->time_s;
  }
  if (summary.slips) document["slips"] = *summary.slips;
  if (summary.trespasses) {
    document["trespasses"] = summary.trespasses->count;
    document["trespass_s"] = summary.trespasses->time_s;
  }
  if (summary.left_handed) document["left_handed"] = true;
  if (summary.guided) document["guided"] = true;
  if (summary.frames_per_s) document["frames_per_s"] = *summary.frames_per_s;
  if (summary.hand_to_pixel) document["hand_to_pixel_ms"] = hand_to_pixel_json(*summary.hand_to_pixel);
  if (summary.colocation) document["colocation"] = colocation_json(*summary.colocation);
  if (summary.sound_latency) document["sound_latency_ms"] = latency_json(*summary.sound_latency);
  if (summary.heard) document["heard"] = heard_json(*summary.heard);
  // A name that is not UTF-8 must not cost the run its summary.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<std::filesystem::path> write_summary(const std::filesystem::path& folder, const Summary& summary) {
  const std::filesystem::path path = folder / kSummaryName;
  if (std::optional<Error> error = write_new_file(path, summary_json(summary))) return *std::move(error);
  return path;
}

}  // namespace fulcrum::record
