#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/cli/version.h"
#include "engine/app/commands/commands.h"
#include "engine/app/prepare/inventory.h"
#include "engine/app/prepare/tape_header.h"
#include "engine/app/run/results.h"
#include "engine/app/run/run_sink.h"
#include "engine/app/run/trial_results.h"
#include "engine/record/digest.h"
#include "engine/record/replay_check.h"
#include "engine/record/run_folder.h"
#include "engine/record/tape_reader.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::app {

namespace {

int replay_command(const std::filesystem::path& file, const RunOptions& options) {
  const Result<record::Tape> tape = record::read_tape(file);
  if (!tape) {
    complain(tape.error().sentence);
    return kError;
  }
  if (!tape->complete)
    complain("the tape ends early (the run was killed or the disk was full): replaying the " +
             std::to_string(tape->entries.size()) + " ticks it holds.");
  if (tape->header.program_version != kVersion)
    complain("the tape was made by version " + tape->header.program_version + ", this is " + kVersion +
             ": ticks may differ.");
  for (const std::string& name : other_devices(*tape))
    complain("the tape's file of the device '" + name +
             "' is not the installed one: its forces may be more than that device has.");
  const Result<Prepared> prepared = prepare_from_tape(*tape);
  if (!prepared) {
    complain(prepared.error().sentence);
    return kError;
  }
  Result<World> world = World::build(scene_for_device(*prepared, tape->header.device));
  if (!world) {
    complain(world.error().sentence);
    return kError;
  }
  const record::TraceColumns columns = trace_columns(*world, prepared->haptic.task);
  Result<OpenResults> results =
      open_results(prepared->name, options, tape->header, *world, prepared->haptic.task);
  if (!results) {
    complain(results.error().sentence);
    return kError;
  }

  const double duration = static_cast<double>(tape->entries.size()) * world->desc().tick_s;
  RunSink sink(*prepared, std::move(results->recorder), duration);
  record::ReplayCheck check;
  ProgressBar bar;
  for (const record::TapeEntry& entry : tape->entries) {
    TickEvent event;
    replay_tick(*world, entry.sample, entry.commands, event);
    event.lost_before = entry.lost_before;
    sink.take(event);
    check.tick({event.record, static_cast<std::int32_t>(sink.task().step), sink.hard_touches()},
               entry.digest);
    bar.show("Replaying", sink.time() / duration);
  }
  bar.clear();

  RunSink::Outcome outcome = sink.finish();
  outcome.summary.device = tape->header.device;
  outcome.summary.hand = tape->header.hand;
  outcome.summary.left_handed = prepared->scenario.left_handed;
  Inventory list = inventory(*world, *prepared, nullptr);
  add_scene_sound(*prepared, world->desc(), false, list);
  const FinishedTrial trial{*prepared,
                            sink,
                            sink.metrics(),
                            outcome.summary,
                            results->folder.path,
                            std::chrono::system_clock::now()};
  const bool written = write_results(results->folder.path, outcome, list) && write_trial_page(trial, "");
  std::printf("%s\n", results->folder.path.string().c_str());
  if (!check.same()) {
    complain(check.divergence(columns, file.parent_path() / record::kTraceName));
    return kError;
  }
  std::printf(
      check.compared() == check.ticks()
          ? "%lld ticks, the same as recorded, bit for bit.\n"
          : "%lld ticks repeated. The tape is of an older format, whose digests are others: whether they "
            "are the same as recorded was not checked.\n",
      static_cast<long long>(check.ticks()));
  return written && outcome.recorded ? kCompleted : kError;
}

}  // namespace

void add_replay(Program& program) {
  const auto tape = std::make_shared<std::string>();
  const auto options = std::make_shared<RunOptions>();
  program.add(
      "replay", "Repeat a run from its tape and compare every tick",
      [tape, options](Arguments& arguments) {
        arguments.required({"tape", "TAPE", "The tape of a run"}, *tape);
        arguments.out(*options);
      },
      [tape, options] { return replay_command(*tape, *options); });
}

}  // namespace fulcrum::app
