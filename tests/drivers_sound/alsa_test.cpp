// Cards by the real ALSA: what reaches one, and what is said of those that cannot be had.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "drivers/sound/sound.h"

namespace fulcrum::test {
namespace {

namespace fs = std::filesystem;
using sound::Frame;
using sound::Pcm;

class Alsa : public testing::Test {
protected:
  Alsa() {
    std::string name = (fs::temp_directory_path() / "fulcrum_alsa_XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~Alsa() override {
    unsetenv("ALSA_CONFIG_PATH");
    fs::remove_all(folder);
  }
  // `card`: the stand-in with these settings. `tape`: the same, and what reaches it is in tape().
  // Each time in a file of another name, since ALSA reads the same one again only when it is a second older.
  void bring(const std::string& settings) {
    const fs::path file = folder / ("asound" + std::to_string(++brought) + ".conf");
    std::ofstream(file) << "pcm_type.stand_in { lib \"" << STAND_IN_CARD << "\" }\n"
                        << "pcm.card { type stand_in " << settings << " }\n"
                        << "pcm.tape { type file slave.pcm card file \"" << tape().string()
                        << "\" format raw }\n";
    setenv("ALSA_CONFIG_PATH", file.c_str(), 1);
  }
  fs::path tape() const { return folder / "tape.raw"; }
  // What is on the tape, as numbers of a type.
  template <class T>
  std::vector<T> taped() const {
    std::ifstream in(tape(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::vector<T> numbers(bytes.size() / sizeof(T));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(T));
    return numbers;
  }
  static std::string why_not(const std::string& pcm, std::size_t channels = 2) {
    const auto opened = sound::open_alsa({.pcm = pcm}, channels, 2000);
    return opened ? "it was opened" : opened.error().sentence;
  }
  fs::path folder;
  int brought = 0;
};

// Of which each channel and sample is another number, the largest and the least among them.
std::vector<Frame> frames() {
  std::vector<Frame> all;
  for (int n = 0; n < 300; ++n)
    all.push_back(
        {static_cast<std::int16_t>(n * 109 - 32768), static_cast<std::int16_t>(32767 - n * 37), 5, 6});
  return all;
}

void write_all(const std::string& pcm, unsigned first, std::size_t channels) {
  auto opened = sound::open_alsa({.pcm = pcm, .first = first}, channels, 2000);
  ASSERT_TRUE(opened) << opened.error().sentence;
  const Pcm::Fill fill = (*opened)->fill();
  EXPECT_EQ(fill.state, Pcm::State::plays);
  EXPECT_EQ(fill.ahead, 0);
  EXPECT_GE(fill.room, 1900);
  (*opened)->write(frames());
}

TEST_F(Alsa, EachFormatCarriesTheSamplesWhole) {
  bring("ahead 384");
  write_all("tape", 0, 2);
  const auto small = taped<std::int16_t>();
  fs::remove(tape());
  bring("ahead 384 format S32_LE");
  write_all("tape", 0, 2);
  const auto wide = taped<std::int32_t>();
  fs::remove(tape());
  bring("ahead 384 format FLOAT_LE");
  write_all("tape", 0, 2);
  const auto real = taped<float>();
  ASSERT_EQ(small.size(), 600U);
  ASSERT_EQ(wide.size(), 600U);
  ASSERT_EQ(real.size(), 600U);
  for (std::size_t n = 0; n < 600; ++n) {
    const std::int16_t wanted = frames()[n / 2][n % 2];
    EXPECT_EQ(small[n], wanted) << n;
    EXPECT_EQ(wide[n], wanted * 65536) << n;
    EXPECT_EQ(real[n], static_cast<float>(wanted) / 32768.0F) << n;
  }
}

// A DualSense has its coils at channels 3 and 4 of four.
TEST_F(Alsa, ChannelsGoWhereTheyAreWired) {
  bring("ahead 384 channels 4");
  write_all("tape", 2, 2);
  const auto numbers = taped<std::int16_t>();
  ASSERT_EQ(numbers.size(), 1200U);
  for (std::size_t n = 0; n < 300; ++n) {
    EXPECT_EQ(numbers[4 * n], 0);
    EXPECT_EQ(numbers[4 * n + 1], 0);
    EXPECT_EQ(numbers[4 * n + 2], frames()[n][0]);
    EXPECT_EQ(numbers[4 * n + 3], frames()[n][1]);
  }
}

TEST_F(Alsa, WhatCannotBeHadSaysWhyAndWhatCuresIt) {
  const auto says = [](const std::string& sentence, std::initializer_list<const char*> parts) {
    for (const char* part : parts) EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  };
  bring("wrong busy");
  says(why_not("card"), {"another program plays on it", "end that one"});
  bring("wrong denied");
  says(why_not("card"), {"you may not open it", "group audio"});
  bring("wrong absent");
  says(why_not("card"), {"'card'", "its card is not there", "/proc/asound/cards"});
  says(why_not("speaker"), {"ALSA knows no PCM 'speaker'"});
  says(why_not("default"), {"no sound card is there: plug one in"});
  bring("rate 44100");
  says(why_not("card"), {"does not play 48000 samples a second, but 44100", "another PCM"});
  bring("format U8");
  says(why_not("card"), {"samples of neither 16 nor 32 bits"});
  bring("channels 1");
  says(why_not("card"), {"has 1 channels, and 2 are needed"});
  bring("");
  EXPECT_EQ(why_not("card"), "it was opened");
}

TEST_F(Alsa, ACardThatRunsDrySaysSoAndPlaysAgain) {
  bring("");
  auto opened = sound::open_alsa({.pcm = "card"}, 2, 2000);
  ASSERT_TRUE(opened) << opened.error().sentence;
  Pcm& pcm = **opened;
  for (int time = 0; time < 2; ++time) {
    pcm.write(frames());
    while (pcm.fill().state == Pcm::State::plays) std::this_thread::yield();
    EXPECT_EQ(pcm.fill().state, Pcm::State::dry);
    ASSERT_TRUE(pcm.restart());
    EXPECT_EQ(pcm.fill().state, Pcm::State::plays);
    EXPECT_EQ(pcm.fill().ahead, 0);
  }
}

VibrotactileDesc coils() {
  const ChannelDesc left{.name = "left", .largest = 10, .resonance_Hz = 233, .quality = 3};
  ChannelDesc right = left;
  right.name = "right";
  return {{left, right}};
}

TEST_F(Alsa, AnUnpluggedCardIsLost) {
  bring("lasts 4000");
  auto link = sound::open_sound({.pcm = "card"}, coils(), {.largest = 10}, 1e-3);
  ASSERT_TRUE(link) << link.error().sentence;
  EXPECT_TRUE((*link)->connected());
  while ((*link)->connected()) {
    (*link)->drive({});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST_F(Alsa, WhatTheTableOrTheTicksAskOfACardIsChecked) {
  bring("");
  VibrotactileDesc slow = coils(), rumble = coils();
  slow.channels[1].rate_Hz = 44100;
  rumble.channels[0].kind = ChannelKind::rumble;
  for (const VibrotactileDesc& wrong : {slow, rumble}) {
    const auto refused = sound::open_sound({.pcm = "card"}, wrong, {.largest = 10}, 1e-3);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence.find("pcm at 48000 Hz"), std::string::npos)
        << refused.error().sentence;
  }
  const auto said = sound::describe_sound({.pcm = "card"}, 1e-3);
  ASSERT_TRUE(said) << said.error().sentence;
  EXPECT_NE(said->find("card: 8 ms from a tick to its output, with periods of 2 ms"), std::string::npos)
      << *said;
}

}  // namespace
}  // namespace fulcrum::test
