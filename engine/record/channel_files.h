#pragma once
// What each vibrotactile channel of a run gets, as WAV files: vibrotactile_motion-NAME.wav. Of pcm its
// samples, at its own rate; of rumble its drive, a sample a tick. Full scale is the full drive. They follow
// from the tick's records alone, so that a replay writes the same bytes.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "engine/record/wav_writer.h"
#include "haptics/actuation/vibrotactile_output.h"

namespace fulcrum::record {

struct ChannelRecording {
  VibrotactileDesc channels;
  VibrotactileSignal signal;
};

class ChannelFiles {
public:
  // Makes the files.
  static Result<ChannelFiles> create(const std::filesystem::path& folder, const ChannelRecording& what,
                                     double tick_s);

  void tick(const VibrotactileCommand& command);

  // All of them or none, as WavWriter does.
  std::optional<Error> flush();
  void take_back();
  std::optional<Error> close();

private:
  struct Channel {
    ChannelOutput output;
    WavWriter file;
  };
  explicit ChannelFiles(std::vector<Channel> channels) : channels_(std::move(channels)) {}

  std::vector<Channel> channels_;
};

}  // namespace fulcrum::record
