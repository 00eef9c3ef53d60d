#include "engine/app/run/expert.h"

#include <sys/stat.h>

#include <string>
#include <utility>

#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/prepare/tape_header.h"
#include "engine/app/run/button_commands.h"
#include "engine/app/run/expert_file.h"
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

std::optional<ExpertRun> read_kept(const std::filesystem::path& file, const std::string& key,
                                   const Prepared& prepared) {
  Result<RegularFile> kept = RegularFile::open(file);
  if (!kept) return std::nullopt;
  const Result<std::string> text = kept->first_bytes(kMostExpertBytes);
  if (!text) return std::nullopt;
  // A run that its limit ended may be a tick longer.
  const double longest = prepared.scenario.time_limit + prepared.haptic.scene.tick_s;
  return read_expert(*text, key, prepared.haptic.task.checkpoints.size(), longest);
}

void keep(const std::filesystem::path& file, const std::string& key, const ExpertRun& run) {
  const std::string text = expert_text(run, key);
  put_file(file, {std::as_bytes(std::span(text))});  // without it the expert is watched again
}

std::optional<ExpertRun> watch(const Prepared& prepared, const std::function<bool(double)>& goes_on) {
  Result<World> world = World::build(prepared.haptic.scene);
  const Result<std::unique_ptr<SimulatedDevice>> device = simulated_device(prepared, kExpert);
  if (!world || !device) return std::nullopt;
  RunSink sink(prepared, std::nullopt, prepared.scenario.time_limit);
  ButtonCommands buttons(kHandStopButton, kHandGoButton);
  std::optional<Command> pressed;
  ToolFilm film(world->desc().tick_s);
  for (std::int64_t tick = 0; sink.end() == RunSink::End::running && !sink.stopped_by_fault(); ++tick) {
    if (tick % kTicksBetweenQuestions == 0 && !goes_on(sink.time() / sink.limit())) return std::nullopt;
    TickEvent event;
    run_tick(*world, **device, {pressed ? &*pressed : nullptr, pressed ? 1U : 0U}, event);
    sink.take(event);
    pressed = buttons.pressed(event.sample.buttons);
    if (!event.record.stopped) film.add(event.record.X_WT, sink.time());
  }
  return ExpertRun{sink.metrics(), sink.task().reached, std::move(film).take()};
}

}  // namespace

std::optional<ExpertRun> watch_expert(const Prepared& prepared, const std::function<bool(double)>& goes_on) {
  if (refuse_hand(prepared.scenario, prepared.name, kExpert)) return std::nullopt;
  const std::string key = key_of(prepared);
  const std::filesystem::path cache = BakeCache().folder();
  const std::filesystem::path file =
      key.empty() || cache.empty() ? std::filesystem::path() : cache / "expert" / (key + ".json");
  if (!file.empty())
    if (auto kept = read_kept(file, key, prepared)) return kept;
  std::optional<ExpertRun> run = watch(prepared, goes_on);
  if (run && !run->way.empty() && !file.empty()) keep(file, key, *run);
  return run;
}

std::optional<ExpertRun> watch_expert_in_terminal(const Prepared& prepared) {
  ProgressBar bar;
  return watch_expert(prepared, [&](double fraction) {
    bar.show("Watching the expert", fraction);
    return !interrupted();
  });
}

}  // namespace fulcrum::app
