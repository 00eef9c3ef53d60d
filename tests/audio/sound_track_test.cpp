// A scene as OpenAL Soft mixes it, without a device: what comes out of the library is measured.

#include "engine/audio/sound_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/audio/samples.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::audio {
namespace {

struct Stereo {
  std::vector<float> left, right;
};

double energy(std::span<const float> samples) {
  double sum = 0;
  for (const float y : samples) sum += static_cast<double>(y) * static_cast<double>(y);
  return sum;
}

double loudest(const Stereo& heard) {
  double most = 0;
  for (const auto* side : {&heard.left, &heard.right})
    for (const float y : *side) most = std::max(most, static_cast<double>(std::abs(y)));
  return most;
}

double steepest(std::span<const float> samples) {
  double most = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    most = std::max(most, static_cast<double>(std::abs(samples[i] - samples[i - 1])));
  return most;
}

SceneSound steel_scene() {
  SceneSound scene;
  scene.reach = 0.3;
  return scene;
}

TickRecord quiet(std::int64_t tick) {
  TickRecord record;
  record.tick = tick;
  record.impact.emplace();
  return record;
}

// Beside the hand, 0.4 m from the listener, who is in the origin and looks along -z.
TickRecord struck_at(std::int64_t tick, const Vec3& p_W, double speed) {
  TickRecord record = quiet(tick);
  record.X_WH.p = p_W;
  record.impact = ImpactTick{1, {p_W, Vec3::UnitY(), speed, 0}};
  return record;
}

class Mix {
public:
  explicit Mix(const SceneSound& scene = steel_scene(), bool hrtf = false)
      : track_(std::move(*SoundTrack::begin(scene, {}, hrtf))) {}

  SoundTrack& track() { return *track_; }
  void take(TickRecord record) {
    record.tick = tick_++;
    const std::span<const float> samples = track_->tick(record);
    for (std::size_t i = 0; i < samples.size(); i += 2) {
      heard_.left.push_back(samples[i]);
      heard_.right.push_back(samples[i + 1]);
    }
  }
  void rest(int ticks) {
    for (int i = 0; i < ticks; ++i) take(quiet(0));
  }
  const Stereo& heard() const { return heard_; }

private:
  std::unique_ptr<SoundTrack> track_;
  std::int64_t tick_ = 0;
  Stereo heard_;
};

Stereo blow_at(const Vec3& p_W, double speed = 0.3, bool hrtf = false) {
  Mix run(steel_scene(), hrtf);
  run.rest(10);
  run.take(struck_at(0, p_W, speed));
  run.rest(1000);
  return run.heard();
}

TEST(SoundTrack, ABlowSoundsFromItsTickOn) {
  const Stereo heard = blow_at({0, 0, -0.4});
  ASSERT_EQ(heard.left.size(), 1011u * 48);
  EXPECT_EQ(energy(std::span(heard.left).first(480)), 0);
  EXPECT_GT(energy(std::span(heard.left).subspan(480, 480)), 0);
}

TEST(SoundTrack, HasFrequencyAndDecayOfTheMaterial) {
  const Stereo heard = blow_at({0, 0, -0.4});
  const auto part = [&](double frequency_Hz, std::size_t from, std::size_t count) {
    std::complex<double> sum;
    for (std::size_t i = from; i < from + count; ++i)
      sum += static_cast<double>(heard.left[i]) *
             std::polar(1.0, -2 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / kRate_Hz);
    return std::abs(sum);
  };
  double best = 0;
  for (double f = 600, most = 0; f < 680; f += 0.2)
    if (const double now = part(f, 480, 24000); now > most) most = now, best = f;
  EXPECT_NEAR(best, 640, 0.5);
  EXPECT_NEAR(std::log(part(640, 4800, 4800) / part(640, 28800, 4800)) / 0.5, 5, 0.05);
}

TEST(SoundTrack, IsLouderTheHarderTheBlow) {
  double before = 0;
  for (double speed = 0.02; speed < 20; speed *= 1.5) {
    const double loud = energy(blow_at({0, 0, -0.4}, speed).left);
    EXPECT_GT(loud, before) << speed;
    before = loud;
  }
}

TEST(SoundTrack, IsOnTheSideWhereTheBlowFell) {
  for (const bool hrtf : {false, true}) {
    const Stereo left = blow_at({-0.4, 0, -0.05}, 0.3, hrtf), right = blow_at({0.4, 0, -0.05}, 0.3, hrtf),
                 ahead = blow_at({0, 0, -0.4}, 0.3, hrtf);
    EXPECT_GT(energy(left.left), 2 * energy(left.right)) << hrtf;
    EXPECT_GT(energy(right.right), 2 * energy(right.left)) << hrtf;
    EXPECT_NEAR(energy(ahead.left) / energy(ahead.right), 1, 0.05) << hrtf;
  }
}

// A listener who has turned round has it on the other side.
TEST(SoundTrack, IsHeardFromWhereTheListenerIs) {
  const auto track = SoundTrack::begin(steel_scene(), {Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY()}, false);
  ASSERT_TRUE(track);
  double left = 0, right = 0;
  for (int i = 0; i < 300; ++i) {
    const auto samples = (*track)->tick(i == 0 ? struck_at(0, {-0.4, 0, 0}, 0.3) : quiet(i));
    for (std::size_t k = 0; k < samples.size(); k += 2) {
      left += static_cast<double>(samples[k]) * static_cast<double>(samples[k]);
      right += static_cast<double>(samples[k + 1]) * static_cast<double>(samples[k + 1]);
    }
  }
  EXPECT_GT(right, 2 * left);
}

TEST(SoundTrack, ManyBlowsAreBoundedAndDoNotClip) {
  Mix run;
  run.rest(10);
  for (int i = 0; i < 3000; ++i) {
    run.take(struck_at(0, {0.1 * std::sin(i), 0, -0.4}, 0.5 + 0.001 * (i * 37 % 400)));
    ASSERT_LE(run.track().stage().sounding(), Stage::kSounding);
  }
  EXPECT_GT(run.track().stage().dropped(), 1000);
  EXPECT_LE(loudest(run.heard()), 1.0);
  EXPECT_GT(loudest(run.heard()), 0.2);
}

TEST(SoundTrack, AVoiceThatMakesRoomFadesAndDoesNotClick) {
  SceneSound low = steel_scene();
  low.materials = {{"gong", 0.8, 0.5, 12}};  // 192 Hz, whose own slope is small
  Mix run(low);
  run.rest(10);
  for (std::size_t i = 0; i < Stage::kSounding; ++i) {
    run.take(struck_at(0, {0, 0, -0.4}, 0.02));
    run.rest(7);
  }
  const double before = steepest(run.heard().left);
  run.take(struck_at(0, {0, 0, -0.4}, 0.03));  // stronger than any that sounds
  run.rest(100);
  EXPECT_EQ(run.track().stage().dropped(), 1);
  EXPECT_EQ(run.track().stage().sounding(), Stage::kSounding);
  EXPECT_LT(steepest(run.heard().left), 1.6 * before);
}

TEST(SoundTrack, MuteIsSilenceWithoutAClick) {
  for (const bool hrtf : {false, true}) {
    Mix run(steel_scene(), hrtf);
    run.take(struck_at(0, {0, 0, -0.4}, 1));
    run.rest(100);
    const double before = steepest(run.heard().left);
    run.track().set_volume(0);
    const std::size_t muted = run.heard().left.size();
    run.rest(20);
    const std::size_t silent = run.heard().left.size();
    run.take(struck_at(0, {0, 0, -0.4}, 1));
    run.track().chime(Chime::checkpoint);
    run.rest(500);
    EXPECT_LE(steepest(std::span(run.heard().left).subspan(muted - 1, silent - muted)), 1.5 * before) << hrtf;
    EXPECT_EQ(energy(std::span(run.heard().left).subspan(silent)), 0) << hrtf;
    EXPECT_EQ(energy(std::span(run.heard().right).subspan(silent)), 0) << hrtf;
    run.track().set_volume(1);
    run.rest(50);
    EXPECT_GT(energy(std::span(run.heard().left).subspan(silent)), 0) << hrtf;
  }
}

TEST(SoundTrack, VolumeIsProportional) {
  Mix whole, half;
  half.track().set_volume(0.5);
  for (Mix* run : {&whole, &half}) {
    run->rest(10);
    run->take(struck_at(0, {0, 0, -0.4}, 0.3));
    run->rest(500);
  }
  EXPECT_NEAR(loudest(half.heard()) / loudest(whole.heard()), 0.5, 0.01);
}

TickRecord sliding(double speed, bool stopped) {
  TickRecord record = quiet(0);
  record.X_WT.p = Vec3(-0.09, 0, -0.02);
  record.regions = 1;
  record.contact_F_T_W.force = Vec3(0, 2, 0);
  record.V_WT.v = Vec3(speed, 0, 0);
  record.stopped = stopped;
  return record;
}

TEST(SoundTrack, SlidingIsHeardWhileItLastsAndNotInAPause) {
  SceneSound scene = steel_scene();
  scene.scene_field = test::floor_field();
  scene.tool_shell = test::shell_of({Vec3::Zero()});
  Mix run(scene);
  run.rest(10);
  for (int i = 0; i < 500; ++i) run.take(sliding(0.1, false));
  const std::size_t slid = run.heard().left.size();
  EXPECT_GT(energy(std::span(run.heard().left).subspan(slid - 9600)),
            2 * energy(std::span(run.heard().right).subspan(slid - 9600)));
  for (int i = 0; i < 500; ++i) run.take(sliding(0.1, true));
  EXPECT_EQ(energy(std::span(run.heard().left).subspan(slid + 12000)), 0);
  EXPECT_LT(steepest(std::span(run.heard().left).subspan(slid - 48)),
            1.5 * steepest(std::span(run.heard().left).first(slid)));
  const std::size_t paused = run.heard().left.size();
  for (int i = 0; i < 500; ++i) run.take(sliding(0, false));  // it rests where it touches
  EXPECT_EQ(energy(std::span(run.heard().left).subspan(paused + 12000)), 0);

  SceneSound without = scene;
  without.slide = 0;
  Mix none(without);
  for (int i = 0; i < 500; ++i) none.take(sliding(0.1, false));
  EXPECT_EQ(loudest(none.heard()), 0);
}

TEST(SoundTrack, IsTheSameEachTime) {
  const Stereo first = blow_at({-0.2, 0.1, -0.3}, 0.3, true), second = blow_at({-0.2, 0.1, -0.3}, 0.3, true);
  EXPECT_EQ(first.left, second.left);
  EXPECT_EQ(first.right, second.right);
}

TEST(SoundTrack, KeepsTimeWhereATickIsNoWholeNumberOfSamples) {
  SceneSound scene = steel_scene();
  scene.tick_s = 1.0 / 700;
  Mix run(scene);
  run.rest(7000);
  EXPECT_EQ(run.heard().left.size(), 480000u);
}

}  // namespace
}  // namespace fulcrum::audio
