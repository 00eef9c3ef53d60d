#include "engine/app/run/results.h"

#include <cctype>
#include <chrono>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/app/cli/listed.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/prepare/tape_header.h"
#include "engine/record/run_folder.h"

namespace fulcrum::app {
namespace {

Result<record::RunFolder> new_run_folder(const std::string& scenario) {
  Result<std::filesystem::path> made = record::make_default_run_folder(
      std::filesystem::path(scenario).stem().string(), std::chrono::system_clock::now());
  if (!made) return made.error();
  return record::prepare_run_folder(*made, false);
}

// "Picture, trace and summary lie in", of those that were written; empty: none was.
std::string what_lies_in(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  const auto add = [&](const char* name, std::string_view file) {
    std::error_code unknown;
    if (std::filesystem::file_size(folder / file, unknown) > 0 && !unknown) files.emplace_back(name);
  };
  add("picture", record::kPictureName);
  add("trace", record::kTraceName);
  add("summary", record::kSummaryName);
  add("report", record::kReportName);
  std::string text = listed(files);
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + (files.size() == 1 ? " lies in" : " lie in");
}

}  // namespace

Result<OpenResults> open_results(const std::string& scenario, const RunOptions& options,
                                 const record::TapeHeader& header, const World& world,
                                 const scenario::TaskDesc& task) {
  Result<record::RunFolder> folder =
      options.out.empty() ? new_run_folder(scenario) : record::prepare_run_folder(options.out, options.force);
  if (!folder) return folder.error();
  Result<record::Recorder> recorder = record::Recorder::begin(
      folder->path, header, trace_columns(world, task), channel_recording(world.desc()));
  if (!recorder) return recorder.error();
  return OpenResults{std::move(*folder), std::move(*recorder)};
}

bool write_results(const std::filesystem::path& folder, RunSink::Outcome& outcome,
                   const Inventory& inventory) {
  for (const InventoryItem& item : inventory.built) outcome.summary.built.push_back(item.name);
  for (const InventoryItem& item : inventory.left_out) outcome.summary.left_out.push_back(item.name);
  const Result<std::filesystem::path> written = record::write_summary(folder, outcome.summary);
  if (written) return true;
  complain(written.error().sentence);
  return false;
}

namespace {

std::string where_deepest(const record::Summary& summary) {
  if (!summary.max_penetration_at_s || !summary.max_penetration_part) return {};
  char text[32];
  std::snprintf(text, sizeof text, " at %.2f s", *summary.max_penetration_at_s);
  return text + (", in " + *summary.max_penetration_part);
}

}  // namespace

void print_outcome(const std::filesystem::path& folder, const RunSink::Outcome& outcome,
                   std::optional<double> score) {
  const record::Summary& summary = outcome.summary;
  if (summary.completed)
    std::printf("%s in %.1f s.\n", bold("Completed").c_str(), summary.completion_time_s.value_or(0));
  else
    std::printf("%s after %.1f s.\n", bold("Not completed").c_str(), outcome.time_s);
  for (const record::CheckpointResult& checkpoint : summary.checkpoints)
    if (checkpoint.reached_s)
      std::printf("  %-24s %6.1f s\n", checkpoint.name.c_str(), *checkpoint.reached_s);
    else
      std::printf("  %-24s %s\n", checkpoint.name.c_str(), dim("not reached").c_str());
  std::printf("  peak force of contact %.2f N, rendered %.2f N; deepest penetration %.3f mm%s\n",
              summary.peak_force_N, summary.peak_force_rendered_N,
              1e3 * summary.max_penetration_m.value_or(0), where_deepest(summary).c_str());
  if (summary.hard_touches)
    std::printf("  %lld hard touches, %.1f s in all\n", static_cast<long long>(summary.hard_touches->count),
                summary.hard_touches->time_s);
  if (summary.slips) std::printf("  %lld slips\n", static_cast<long long>(*summary.slips));
  if (summary.trespasses)
    std::printf("  %lld trespasses, %.1f s in all\n", static_cast<long long>(summary.trespasses->count),
                summary.trespasses->time_s);
  if (summary.guided) std::printf("  guided: this trial has no score\n");
  if (score) std::printf("  score %.0f of 100, by the rules of docs/results.md\n", *score);
  for (const record::FaultCount& fault : summary.faults) std::printf("  %s\n", fault.sentence.c_str());
  if (const std::string files = what_lies_in(folder); !files.empty())
    std::printf("%s %s\n", files.c_str(), bold(folder.string()).c_str());
}

}  // namespace fulcrum::app
