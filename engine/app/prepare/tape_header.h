#pragma once
// What a tape says about the run besides its ticks.

#include <optional>
#include <string>
#include <vector>

#include "engine/app/prepare/prepare.h"
#include "engine/record/channel_files.h"
#include "engine/record/tape.h"
#include "engine/record/trace_columns.h"

namespace fulcrum::app {

Result<record::TapeHeader> tape_header(const Prepared& prepared, const std::string& device,
                                       const std::string& hand);

// The scenario a tape was made with: from its texts, and models that are the same, byte for byte.
Result<Prepared> prepare_from_tape(const record::Tape& tape);

// Names of the installed devices whose file in the tape is another one. A tape repeats what was, and so it
// goes by its own.
std::vector<std::string> other_devices(const record::Tape& tape);

// With a column for each motor of the device that the scene runs on, and for what the task counts.
record::TraceColumns trace_columns(const World& world, const scenario::TaskDesc& task);

// The channels that the scene vibrates; none: nothing does.
std::optional<record::ChannelRecording> channel_recording(const SceneDesc& scene);

}  // namespace fulcrum::app
