// WAV files, read back byte by byte after the format's description.

#include "engine/record/wav_writer.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cstdint>
#include <string>
#include <vector>

#include "engine/record/channel_files.h"
#include "tests/record/synthetic_run.h"

namespace fulcrum::record {
namespace {

std::uint32_t number(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

std::vector<int> samples_of(const std::string& bytes) {
  std::vector<int> samples;
  for (std::size_t at = 44; at + 1 < bytes.size(); at += 2)
    samples.push_back(static_cast<std::int16_t>(number(bytes, at, 2)));
  return samples;
}

// Every field of the header, for that many samples in the file.
void expect_header(const std::string& bytes, std::uint32_t rate_Hz, std::uint32_t samples) {
  ASSERT_EQ(bytes.size(), 44 + 2 * samples);
  EXPECT_EQ(bytes.substr(0, 4), "RIFF");
  EXPECT_EQ(number(bytes, 4, 4), bytes.size() - 8);
  EXPECT_EQ(bytes.substr(8, 8), "WAVEfmt ");
  EXPECT_EQ(number(bytes, 16, 4), 16u);
  EXPECT_EQ(number(bytes, 20, 2), 1u);
  EXPECT_EQ(number(bytes, 22, 2), 1u);
  EXPECT_EQ(number(bytes, 24, 4), rate_Hz);
  EXPECT_EQ(number(bytes, 28, 4), 2 * rate_Hz);
  EXPECT_EQ(number(bytes, 32, 2), 2u);
  EXPECT_EQ(number(bytes, 34, 2), 16u);
  EXPECT_EQ(bytes.substr(36, 4), "data");
  EXPECT_EQ(number(bytes, 40, 4), 2 * samples);
}

TEST(Wav, OfTwoChannelsTheHeaderSaysSo) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "stereo.wav";
  Result<WavWriter> writer = WavWriter::create(path, 48000, 2);
  ASSERT_TRUE(writer);
  const std::vector<double> frames{0.25, -0.25, 0.5, -0.5, 1, -1};
  writer->add(frames);
  ASSERT_FALSE(writer->flush());
  const std::string bytes = contents(path);
  EXPECT_EQ(number(bytes, 22, 2), 2u);
  EXPECT_EQ(number(bytes, 24, 4), 48000u);
  EXPECT_EQ(number(bytes, 28, 4), 4 * 48000u);
  EXPECT_EQ(number(bytes, 32, 2), 4u);
  EXPECT_EQ(number(bytes, 34, 2), 16u);
  EXPECT_EQ(number(bytes, 40, 4), 12u);
  EXPECT_EQ(samples_of(bytes), (std::vector<int>{8192, -8192, 16384, -16384, 32767, -32767}));
}

TEST(Wav, TheFileIsWholeAfterEachBlock) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "tone.wav";
  Result<WavWriter> writer = WavWriter::create(path, 44100);
  ASSERT_TRUE(writer);
  expect_header(contents(path), 44100, 0);
  const std::vector<double> first{0, 0.5, -0.5, 1, -1, 2, -2}, second{0.25};
  writer->add(first);
  expect_header(contents(path), 44100, 0);  // not yet
  ASSERT_FALSE(writer->flush());
  expect_header(contents(path), 44100, 7);
  EXPECT_EQ(samples_of(contents(path)), (std::vector<int>{0, 16384, -16384, 32767, -32767, 32767, -32767}));
  writer->add(second);
  ASSERT_FALSE(writer->flush());
  expect_header(contents(path), 44100, 8);
  writer->take_back();
  expect_header(contents(path), 44100, 7);
  writer->add(second);
  ASSERT_FALSE(writer->flush());
  ASSERT_FALSE(writer->close());
  expect_header(contents(path), 44100, 8);
  EXPECT_EQ(samples_of(contents(path)).back(), 8192);
}

// The file ends with the last whole block, and its header agrees.
TEST(Wav, WhatDoesNotFitIsASentence) {
  const TemporaryFolder folder;
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{100'000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  Result<WavWriter> writer = WavWriter::create(folder / "tone.wav", 48000);
  ASSERT_TRUE(writer);
  const std::vector<double> block(12000, 0.1);
  std::optional<Error> error;
  int blocks = 0;
  for (; !error && blocks < 20; ++blocks) {
    writer->add(block);
    error = writer->flush();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  ASSERT_TRUE(error);
  EXPECT_NE(error->sentence.find("tone.wav"), std::string::npos) << error->sentence;
  EXPECT_EQ(blocks, 5);
  expect_header(contents(folder / "tone.wav"), 48000, 4 * 12000);
}

TEST(Wav, EachChannelHasAFileOfItsOwnRate) {
  const TemporaryFolder folder;
  const ChannelDesc coil{.name = "left", .largest = 10, .rate_Hz = 8000, .resonance_Hz = 233, .quality = 3};
  const ChannelDesc motor{.name = "right", .kind = ChannelKind::rumble, .largest = 8, .lag = 0.04};
  Result<ChannelFiles> files =
      ChannelFiles::create(folder.path(), {{{coil, motor}}, {.carrier_Hz = 233, .largest = 10}}, 1e-3);
  ASSERT_TRUE(files);
  for (int n = 0; n < 500; ++n) files->tick({.level = {5, 4, 0, 0}, .glide = 0.01});
  ASSERT_FALSE(files->flush());
  ASSERT_FALSE(files->close());
  const std::string left = contents(folder / "vibrotactile_motion-left.wav");
  const std::string right = contents(folder / "vibrotactile_motion-right.wav");
  expect_header(left, 8000, 4000);
  expect_header(right, 1000, 500);
  EXPECT_EQ(samples_of(right)[250], 16384);  // half of its drive
  const std::vector<int> samples = samples_of(left);
  int crossings = 0, most = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    crossings += samples[i - 1] < 0 && samples[i] >= 0;
    most = std::max(most, std::abs(samples[i]));
  }
  EXPECT_NEAR(crossings, 233 / 2, 1);  // in half a second
  EXPECT_NEAR(most, 16384, 60);
}

}  // namespace
}  // namespace fulcrum::record
