#include "engine/record/wav_writer.h"

#include <utility>

#include "haptics/actuation/pcm_sample.h"

namespace fulcrum::record {

namespace {

constexpr std::uint32_t kHeaderBytes = 44, kSampleBytes = 2;
constexpr std::size_t kLargest = 0xffffffff;  // bytes

// Lowest byte first.
void put(std::string& to, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> (8 * i) & 0xffu);
}

std::string header(std::uint32_t rate_Hz, std::uint32_t channels, std::uint32_t samples) {
  const std::uint32_t bytes = samples * kSampleBytes;
  std::string text = "RIFF";
  put(text, kHeaderBytes - 8 + bytes, 4);
  text += "WAVEfmt ";
  put(text, 16, 4);  // bytes of the format
  put(text, 1, 2);   // PCM
  put(text, channels, 2);
  put(text, rate_Hz, 4);                            // frames a second
  put(text, rate_Hz * channels * kSampleBytes, 4);  // bytes a second
  put(text, channels * kSampleBytes, 2);            // bytes a frame
  put(text, 8 * kSampleBytes, 2);                   // bits a sample
  text += "data";
  put(text, bytes, 4);
  return text;
}

}  // namespace

Result<WavWriter> WavWriter::create(const std::filesystem::path& path, std::uint32_t rate_Hz,
                                    std::uint32_t channels) {
  Result<BlockFile> file = BlockFile::create(path);
  if (!file) return file.error();
  if (std::optional<Error> error = file->append(header(rate_Hz, channels, 0))) return *std::move(error);
  return WavWriter(std::move(*file), rate_Hz, channels);
}

void WavWriter::add(std::span<const double> samples) {
  for (const double sample : samples)
    put(pending_, static_cast<std::uint32_t>(pcm_sample(sample)), kSampleBytes);
}

std::optional<Error> WavWriter::flush() {
  const std::string block = std::exchange(pending_, {});
  previous_ = samples_;
  if (block.size() > kLargest - kHeaderBytes - std::size_t{samples_} * kSampleBytes)
    return Error{"A WAV file holds 4 GiB at most, and one is full: run the scenario for a shorter time."};
  if (std::optional<Error> error = file_.append(block)) return error;
  samples_ += static_cast<std::uint32_t>(block.size() / kSampleBytes);
  std::optional<Error> error = file_.overwrite_head(header(rate_Hz_, channels_, samples_));
  if (error) take_back();
  return error;
}

void WavWriter::take_back() {
  file_.take_back();
  samples_ = previous_;
  // Where it fails, the header tells of more samples than there are, and players stop at the file's end.
  static_cast<void>(file_.overwrite_head(header(rate_Hz_, channels_, samples_)));
}

}  // namespace fulcrum::record
