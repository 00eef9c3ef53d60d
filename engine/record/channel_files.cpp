#include "engine/record/channel_files.h"

#include <cmath>
#include <string>
#include <utility>

#include "engine/record/run_folder.h"

namespace fulcrum::record {

Result<ChannelFiles> ChannelFiles::create(const std::filesystem::path& folder, const ChannelRecording& what,
                                          double tick_s) {
  std::vector<Channel> channels;
  for (const ChannelDesc& channel : what.channels.channels) {
    ChannelOutput output(channel, what.signal, tick_s);
    Result<WavWriter> file = WavWriter::create(folder / channel_file_name(channel.name),
                                               static_cast<std::uint32_t>(std::lround(output.rate_Hz())));
    if (!file) return file.error();
    channels.push_back({std::move(output), std::move(*file)});
  }
  return ChannelFiles(std::move(channels));
}

void ChannelFiles::tick(const VibrotactileCommand& command) {
  for (std::size_t i = 0; i < channels_.size(); ++i)
    channels_[i].file.add(channels_[i].output.process(command.level[i], command));
}

std::optional<Error> ChannelFiles::flush() {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (std::optional<Error> failure = channels_[i].file.flush()) {
      for (std::size_t before = 0; before < i; ++before) channels_[before].file.take_back();
      return failure;
    }
  }
  return std::nullopt;
}

void ChannelFiles::take_back() {
  for (Channel& channel : channels_) channel.file.take_back();
}

std::optional<Error> ChannelFiles::close() {
  std::optional<Error> first;
  for (Channel& channel : channels_) {
    std::optional<Error> failure = channel.file.close();
    if (!first) first = std::move(failure);
  }
  return first;
}

}  // namespace fulcrum::record
