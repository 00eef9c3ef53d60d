// The player's own thread, on OpenAL Soft's device that plays nowhere but keeps time as a card does.

#include "engine/audio/player.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "haptics/loop/age_clock.h"

namespace fulcrum::audio {
namespace {

// NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet.
class NullDevice final : public testing::Environment {
public:
  void SetUp() override {
    setenv("ALSOFT_DRIVERS", "null", 1);
    settle_library();
  }
};
// NOLINTEND(concurrency-mt-unsafe)
const testing::Environment* const kNullDevice = testing::AddGlobalTestEnvironment(new NullDevice);

// Waits until it is so; fails after a minute.
template <class Done>
void until(const char* what, Done&& done) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!done()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << what;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TimedTick told_blow(std::int64_t tick, std::int64_t at_ns, double speed = 0.3) {
  TimedTick told;
  told.at_ns = at_ns;
  told.record.tick = tick;
  told.record.impact = ImpactTick{1, {Vec3(0, 0, -0.4), Vec3::UnitY(), speed, 0}};
  return told;
}

class PlayerTest : public testing::Test {
protected:
  void SetUp() override {
    Result<Output> output = Output::open();
    ASSERT_TRUE(output) << output.error().sentence;
    SceneSound scene;
    scene.reach = 0.3;
    player_ = std::make_unique<Player>(std::move(*output), scene);
  }
  bool tell(const TimedTick& tick) { return player_->ticks().push(tick); }

  std::unique_ptr<Player> player_;
};

TEST_F(PlayerTest, PlaysABlowAndKnowsWhenItIsHeard) {
  EXPECT_EQ(player_->device(), "No Output, HRTF");
  player_->hear_from({});
  ASSERT_TRUE(tell(told_blow(0, AgeClock::now_ns())));
  until("the blow is measured", [&] { return player_->counts().measured == 1; });
  const PlayedCounts counts = player_->counts();
  EXPECT_EQ(counts.blows, 1);
  EXPECT_EQ(counts.late, 0);
  EXPECT_EQ(counts.latency_sum, counts.latency_most);
  // The device holds 3 of its 4 periods of 256 samples ahead: no blow can be heard sooner.
  EXPECT_GT(counts.latency_most, 3 * 256.0 / 48000 - 1e-3);
}

TEST_F(PlayerTest, DoesNotPlayWhatIsLongPast) {
  ASSERT_TRUE(tell(told_blow(0, AgeClock::now_ns() - 1'000'000'000)));
  until("the late blow is counted", [&] { return player_->counts().late == 1; });
  EXPECT_EQ(player_->counts().blows, 0);
}

TEST_F(PlayerTest, AfterTheEndNothingBegins) {
  player_->rest();
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(tell(told_blow(i, AgeClock::now_ns())));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  until("the ticks are heard", [&] { return player_->ticks().size() == 0; });
  EXPECT_EQ(player_->counts().blows, 0);
}

// A player whose thread gets no turn for long hears only what is long past: the storm lasts until some of it
// was played.
TEST_F(PlayerTest, AStormOfBlowsFromOneThreadAndOfWordsFromAnother) {
  std::atomic<bool> calm{false};
  std::thread haptic([&] {
    for (std::int64_t i = 0; !calm.load(); ++i) {
      tell(told_blow(i, AgeClock::now_ns(), 0.1 + 1e-4 * static_cast<double>(i % 2000)));
      if (i % 4 == 0) std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
  });
  int words = 0;
  until("blows are played and dropped for stronger ones", [&] {
    for (int i = 0; i < 20; ++i, ++words) {
      player_->hear_from({Vec3(0.01 * (words % 200), 0, 0), -Vec3::UnitZ(), Vec3::UnitY()});
      player_->set_volume(words % 2);
      player_->chime(static_cast<Chime>(words % kChimes));
    }
    const PlayedCounts counts = player_->counts();
    return counts.blows > 0 && counts.dropped > 0 && words > 200;
  });
  calm = true;
  haptic.join();
  until("the ring is empty", [&] { return player_->ticks().size() == 0; });
}

TEST(Output, SaysThatThereIsNoDevice) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  // A process of its own, since the library looks for its systems once.
  EXPECT_EXIT(
      {
        setenv("ALSOFT_DRIVERS", "alsa", 1);        // NOLINT(concurrency-mt-unsafe): no thread runs yet.
        setenv("ALSA_CONFIG_PATH", "/nothing", 1);  // NOLINT(concurrency-mt-unsafe)
        settle_library();
        const Result<Output> output = Output::open();
        // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing else ends this process.
        std::exit(!output && output.error().sentence.find("no sound device") != std::string::npos ? 0 : 1);
      },
      testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace fulcrum::audio
