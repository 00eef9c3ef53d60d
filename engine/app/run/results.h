#pragma once
// The folder a run's results go to: opened before the run, closed after it.

#include <filesystem>

#include "engine/app/cli/run_options.h"
#include "engine/app/prepare/inventory.h"
#include "engine/app/run/run_sink.h"
#include "engine/record/recorder.h"
#include "engine/record/run_folder.h"

namespace fulcrum::app {

struct OpenResults {
  record::RunFolder folder;  // for as long as anything is written into it
  record::Recorder recorder;
};

Result<OpenResults> open_results(const std::string& scenario, const RunOptions& options,
                                 const record::TapeHeader& header, const World& world,
                                 const scenario::TaskDesc& task);

// summary.json, with the lists of what was built. False if it could not be written; the sentence is on
// stderr.
bool write_results(const std::filesystem::path& folder, RunSink::Outcome& outcome,
                   const Inventory& inventory);

// A few lines for a person: what came of the run and where everything lies.
// score: 0 to 100; none: nothing could be compared.
void print_outcome(const std::filesystem::path& folder, const RunSink::Outcome& outcome,
                   std::optional<double> score);

}  // namespace fulcrum::app
