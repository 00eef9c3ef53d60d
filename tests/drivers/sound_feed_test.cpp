// What a card is fed with, turn by turn, against a card and a clock that the test moves.

#include "drivers/sound/sound_feed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/drivers/sound_card.h"

namespace fulcrum::test {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kTone_Hz = 233;
constexpr VibrotactileSignal kTone{.carrier_Hz = kTone_Hz, .largest = 10};

// Coils whose resonance is at the tone: a level of 5 of 10 m/s^2 is half a drive.
VibrotactileDesc coils() {
  const ChannelDesc left{.name = "left", .largest = 10, .resonance_Hz = kTone_Hz, .quality = 3};
  ChannelDesc right = left;
  right.name = "right";
  return {{left, right}};
}

// A haptic thread, a feed and a card, each with a clock of its own.
struct Playing {
  explicit Playing(double tick = 1e-3, double card_ppm = 0)
      : tick_s(tick),
        card_rate(48000 * (1 + 1e-6 * card_ppm)),
        plan(sound::feed_plan(tick, card.period)),
        pcm(card),
        told(static_cast<std::size_t>(static_cast<double>(plan.most) / plan.tick) + 8),
        feed(coils(), kTone, tick, plan) {}

  void tell() {
    VibrotactileCommand command;
    command.level = {level, level / 2};
    command.glide = tick_s;
    told.push({command, now_ns});
  }
  // A millisecond of all three. ticks: the haptic thread is on time.
  bool pass(bool ticks = true, bool turns = true) {
    now_ns += 1'000'000;
    card.pass(card_rate * 1e-3);
    for (due += ticks ? 1e-3 / tick_s : 0; due >= 1 - 1e-9; due -= 1) tell();
    if (!turns) return true;
    const bool there = feed.turn(pcm, told, now_ns);
    least = std::min(least, card.ahead);
    most = std::max(most, card.ahead);
    return there;
  }
  // The largest step from one sample to the next, from the frame `from` on.
  int largest_step(std::size_t from = 0) const {
    int step = 0;
    for (std::size_t n = from + 1; n < card.written.size(); ++n)
      step = std::max(step, std::abs(card.written[n][0] - card.written[n - 1][0]));
    return step;
  }

  double tick_s, card_rate;
  SoundCard card;
  sound::FeedPlan plan;
  SoundCardPcm pcm;
  sound::ToldTicks told;
  sound::SoundFeed feed;
  std::int64_t now_ns = 1'000'000'000;
  double level = 5, due = 0;
  double least = 1e9, most = 0;  // frames ahead, after a turn
};

// A tone of half the drive: its steepest, and what rounding adds.
const int kToneStep = static_cast<int>(std::ceil(0.5 * 32767 * 2 * kHalfTurn * kTone_Hz / 48000)) + 2;

TEST(SoundFeed, PlaysTheToneThatIsTold) {
  Playing playing;
  for (int ms = 0; ms < 500; ++ms) ASSERT_TRUE(playing.pass());
  const std::vector<sound::Frame>& written = playing.card.written;
  std::size_t begin = 0;
  while (begin < written.size() && written[begin][0] == 0) ++begin;
  ASSERT_LT(begin, 1000U) << "nothing is played";
  // The burst begins at phase 0, whose sample is silent too, and rises by 1 % of I_max a sample.
  const double held = kHalfTurn * kTone_Hz / 48000;
  for (std::size_t n = begin; n < written.size(); ++n) {
    const auto k = static_cast<double>(n - begin + 1);
    const double envelope = std::min(0.5, 0.01 * (k + 1));
    const double sample = envelope * std::sin(2 * kHalfTurn * kTone_Hz * k / 48000) * held / std::sin(held);
    ASSERT_NEAR(written[n][0], 32767 * sample, 0.51 + 33) << n;  // a sample of the rise
    if (envelope == 0.5) {
      ASSERT_NEAR(written[n][0], 32767 * sample, 0.51) << n;
      ASSERT_NEAR(written[n][1], 32767 * sample / 2, 0.51) << n;
    }
    EXPECT_EQ(written[n][2], 0);
  }
  const sound::FeedCounts& counts = playing.feed.counts();
  EXPECT_EQ(counts.ticks, 500);
  EXPECT_EQ(counts.left_out + counts.doubled + counts.gaps + counts.dry, 0);
  // The card was filled to the aim before the first tick, and that is what each waits for.
  EXPECT_NEAR(48e3 * counts.latency_sum / 500, static_cast<double>(playing.plan.aim), 1);
  EXPECT_NEAR(48e3 * counts.latency_most, static_cast<double>(playing.plan.aim), 1);
}

// The level stays where it should be, as many ticks are left out or doubled as the clocks drift apart, and
// the tone goes on without a jump.
TEST(SoundFeed, ClocksThatDifferAreFollowedWithoutAJump) {
  for (const double ppm : {-500.0, -100.0, 0.0, 100.0, 500.0}) {
    Playing playing(1e-3, ppm);
    constexpr int kSeconds = 120;
    for (int ms = 0; ms < 1000 * kSeconds; ++ms) ASSERT_TRUE(playing.pass()) << ppm;
    const sound::FeedCounts& counts = playing.feed.counts();
    const double drift = 1e-6 * ppm * kSeconds * 1000;  // ticks
    EXPECT_NEAR(static_cast<double>(counts.doubled - counts.left_out), drift, 2) << ppm;
    EXPECT_EQ(std::min(counts.doubled, counts.left_out), 0) << ppm;
    EXPECT_EQ(counts.gaps + counts.dry, 0) << ppm;
    EXPECT_LE(playing.largest_step(), kToneStep) << ppm;
    EXPECT_GE(playing.least, static_cast<double>(playing.plan.aim - 3 * 48)) << ppm;
    EXPECT_LE(playing.most, static_cast<double>(playing.plan.aim + 3 * 48)) << ppm;
  }
}

TEST(SoundFeed, EveryTickRateIsPlayed) {
  for (const double rate_Hz : {100.0, 333.0, 1000.0, 4000.0, 20000.0}) {
    for (const double ppm : {-300.0, 300.0}) {
      Playing playing(1 / rate_Hz, ppm);
      for (int ms = 0; ms < 30000; ++ms) ASSERT_TRUE(playing.pass()) << rate_Hz;
      const sound::FeedCounts& counts = playing.feed.counts();
      EXPECT_EQ(counts.gaps + counts.dry, 0) << rate_Hz;
      EXPECT_LE(playing.largest_step(), kToneStep) << rate_Hz;
      EXPECT_LE(playing.most, static_cast<double>(playing.plan.most)) << rate_Hz;
      EXPECT_EQ(playing.pcm.too_many(), 0) << rate_Hz;
      EXPECT_GT(counts.ticks, static_cast<std::int64_t>(29 * rate_Hz)) << rate_Hz;
    }
  }
}

// From the last tick that came on: no tone is stuck, and none is cut off.
TEST(SoundFeed, WithoutTicksItFallsSilentAndComesBack) {
  Playing playing;
  for (int ms = 0; ms < 200; ++ms) playing.pass();
  const std::size_t told = playing.card.written.size();
  for (int ms = 0; ms < 100; ++ms) ASSERT_TRUE(playing.pass(false));
  const std::vector<sound::Frame> silent = playing.card.written;
  ASSERT_GE(silent.size(), told + 4000) << "the card is kept playing";
  EXPECT_NE(silent[told + 10][0], 0) << "it falls, and is not cut";
  for (std::size_t n = told + 2 * 48; n < silent.size(); ++n)
    ASSERT_EQ(silent[n][0], 0) << n - told << " frames after the last tick";
  EXPECT_EQ(playing.feed.counts().gaps, 0) << "a gap is one where ticks come again";
  for (int ms = 0; ms < 200; ++ms) ASSERT_TRUE(playing.pass());
  EXPECT_NE(playing.card.written.back()[0], 0);
  EXPECT_EQ(playing.feed.counts().gaps, 1);
  EXPECT_EQ(playing.feed.counts().dry, 0);
  // A fall within 2 ms of half the drive is steeper than the tone by at most 1 in 48 samples of it.
  EXPECT_LE(playing.largest_step(), kToneStep + 32767 / 48);
  EXPECT_LE(playing.most, static_cast<double>(playing.plan.most));
}

// As much as the haptic loop catches up with after it was held up.
TEST(SoundFeed, TicksThatAreLateByFourAreNotMissed) {
  Playing late, on_time;
  for (int ms = 0; ms < 2000; ++ms) {
    on_time.pass();
    const bool held_up = ms % 100 >= 50 && ms % 100 < 54;
    late.pass(!held_up);
    if (ms % 100 == 54)
      for (int n = 0; n < 4; ++n) late.tell();
    if (ms % 100 == 54) late.feed.turn(late.pcm, late.told, late.now_ns);
  }
  EXPECT_EQ(late.feed.counts().gaps, 0);
  EXPECT_EQ(late.feed.counts().left_out + late.feed.counts().doubled, 0);
  EXPECT_EQ(late.card.written, on_time.card.written);
}

TEST(SoundFeed, ACardThatRanDryIsCountedAndPlaysAgain) {
  Playing playing;
  for (int ms = 0; ms < 200; ++ms) playing.pass();
  const std::size_t before = playing.card.written.size();
  for (int ms = 0; ms < 30; ++ms) playing.pass(true, false);
  ASSERT_TRUE(playing.card.dry);
  for (int ms = 0; ms < 3000; ++ms) ASSERT_TRUE(playing.pass()) << ms;
  const sound::FeedCounts& counts = playing.feed.counts();
  EXPECT_EQ(counts.dry, 1);
  EXPECT_GT(counts.left_out, 0) << "what is late by then is not played";
  EXPECT_EQ(playing.card.written[before][0], 0) << "from silence on";
  EXPECT_LE(playing.largest_step(before), kToneStep);
  EXPECT_NE(playing.card.written.back()[0], 0);
  EXPECT_NEAR(playing.card.ahead, static_cast<double>(playing.plan.aim), 2 * 48);
}

TEST(SoundFeed, ACardThatTakesNothingIsLost) {
  Playing playing;
  for (int ms = 0; ms < 200; ++ms) playing.pass();
  playing.card.runs = false;
  int there = 0;
  while (playing.pass() && there < 5000) ++there;
  EXPECT_GT(there, 300);
  EXPECT_LT(there, 700);
  EXPECT_EQ(playing.pcm.too_many(), 0);
}

TEST(SoundFeed, ACardThatIsGoneIsLost) {
  Playing playing;
  for (int ms = 0; ms < 20; ++ms) ASSERT_TRUE(playing.pass());
  playing.card.plug(false);
  EXPECT_FALSE(playing.pass());
}

// The tone that was on when it was unplugged is not on when it is back.
TEST(SoundFeed, ACardThatIsBackBeginsFromSilence) {
  Playing playing;
  for (int ms = 0; ms < 200; ++ms) playing.pass();
  playing.card.plug(false);
  EXPECT_FALSE(playing.pass(false));
  playing.card.plug(true);
  playing.card.written.clear();
  playing.feed.begin();
  for (int ms = 0; ms < 20; ++ms) ASSERT_TRUE(playing.pass(false));
  ASSERT_GT(playing.card.written.size(), 384U);
  for (const sound::Frame& frame : playing.card.written) ASSERT_EQ(frame[0], 0);
  for (int ms = 0; ms < 200; ++ms) ASSERT_TRUE(playing.pass());
  EXPECT_LE(playing.largest_step(), kToneStep);
  EXPECT_NE(playing.card.written.back()[0], 0);
}

TEST(SoundFeed, TheEndIsSilence) {
  Playing playing;
  for (int ms = 0; ms < 200; ++ms) playing.pass();
  const std::size_t told = playing.card.written.size();
  playing.feed.finish(playing.pcm);
  const std::vector<sound::Frame>& written = playing.card.written;
  EXPECT_GT(written.size(), told);
  EXPECT_LE(written.size(), told + 3 * 48);
  EXPECT_EQ(written.back()[0], 0);
  EXPECT_EQ(written.back()[1], 0);
  EXPECT_LE(playing.largest_step(), kToneStep + 32767 / 48);
}

}  // namespace
}  // namespace fulcrum::test
