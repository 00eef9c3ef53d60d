#include "engine/app/run/expert.h"

#include <sys/stat.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/prepare/tape_header.h"
#include "engine/app/run/run_sink.h"
#include "engine/assets/bake_cache.h"
#include "engine/assets/sha256.h"
#include "engine/files/put_file.h"
#include "engine/files/regular_file.h"
#include "engine/record/tape_header.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::app {
namespace {

constexpr const char* kExpert = "expert";
constexpr std::uint64_t kMostBytes = 1 << 16;
constexpr std::int64_t kTicksBetweenQuestions = 256;

// The program counts too: another build may move the tool in other ways. Empty: it cannot be told.
std::string this_program() {
  struct stat status {};
  if (::stat("/proc/self/exe", &status) != 0) return {};
  return std::to_string(status.st_size) + ' ' + std::to_string(status.st_mtim.tv_sec) + ' ' +
         std::to_string(status.st_mtim.tv_nsec);
}

// Of all that the figures depend on; empty: they are not kept.
std::string key_of(const Prepared& prepared) {
  const Result<record::TapeHeader> header = tape_header(prepared, "simulated", kExpert);
  if (!header) return {};
  const Result<std::string> text = record::tape_header_json(*header);
  const std::string program = this_program();
  if (!text || program.empty()) return {};
  Sha256 sum;
  sum.update(program);
  sum.update("\n");
  sum.update(*text);
  return sum.finish_hex();
}

std::optional<session::TrialMetrics> read_kept(const std::filesystem::path& file, const std::string& key) {
  Result<RegularFile> kept = RegularFile::open(file);
  if (!kept) return std::nullopt;
  const Result<std::string> bytes = kept->first_bytes(kMostBytes);
  if (!bytes) return std::nullopt;
  const nlohmann::json document = nlohmann::json::parse(*bytes, nullptr, false);
  if (!document.is_object() || document.value("key", nlohmann::json()) != key) return std::nullopt;
  const auto figures = document.find("figures");
  if (figures == document.end() || !figures->is_object()) return std::nullopt;
  std::vector<std::pair<std::string, double>> values;
  for (const auto& [name, value] : figures->items()) {
    if (!value.is_number()) return std::nullopt;
    values.emplace_back(name, value.get<double>());
  }
  return session::from_named_values(values);
}

void keep(const std::filesystem::path& file, const std::string& key, const session::TrialMetrics& metrics) {
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();
  for (const auto& [name, value] : named_values(metrics)) figures[name] = value;
  const nlohmann::ordered_json document = {{"key", key}, {"figures", figures}};
  const std::string text = document.dump(1) + '\n';
  put_file(file, {std::as_bytes(std::span(text))});  // without it the expert is watched again
}

std::optional<session::TrialMetrics> watch(const Prepared& prepared,
                                           const std::function<bool(double)>& goes_on) {
  Result<World> world = World::build(prepared.haptic.scene);
  const Result<std::unique_ptr<SimulatedDevice>> device = simulated_device(prepared, kExpert);
  if (!world || !device) return std::nullopt;
  RunSink sink(prepared, std::nullopt, prepared.scenario.time_limit);
  for (std::int64_t tick = 0; sink.end() == RunSink::End::running && !sink.stopped_by_fault(); ++tick) {
    if (tick % kTicksBetweenQuestions == 0 && !goes_on(sink.time() / sink.limit())) return std::nullopt;
    TickEvent event;
    run_tick(*world, **device, {}, event);
    sink.take(event);
  }
  return sink.metrics();
}

}  // namespace

std::optional<session::TrialMetrics> watch_expert(const Prepared& prepared,
                                                  const std::function<bool(double)>& goes_on) {
  if (refuse_hand(prepared.scenario, prepared.name, kExpert)) return std::nullopt;
  const std::string key = key_of(prepared);
  const std::filesystem::path cache = BakeCache().folder();
  const std::filesystem::path file =
      key.empty() || cache.empty() ? std::filesystem::path() : cache / "expert" / (key + ".json");
  if (!file.empty())
    if (auto kept = read_kept(file, key)) return kept;
  std::optional<session::TrialMetrics> metrics = watch(prepared, goes_on);
  if (metrics && !file.empty()) keep(file, key, *metrics);
  return metrics;
}

}  // namespace fulcrum::app
