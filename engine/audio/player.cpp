#include "engine/audio/player.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "haptics/loop/age_clock.h"

namespace fulcrum::audio {
namespace {

constexpr std::chrono::milliseconds kTurn{2};
constexpr std::chrono::milliseconds kFallSilent{
    40};                                // longer than the library's periods that are mixed ahead
constexpr double kRingSeconds = 0.25;   // of ticks
constexpr std::size_t kMostChimes = 8;  // that wait

}  // namespace

Player::Player(Output output, SceneSound scene)
    : output_(std::move(output)),
      scene_(std::move(scene)),
      ticks_(static_cast<std::size_t>(std::ceil(kRingSeconds / scene_.tick_s))),
      listener_(scene_),
      thread_([this] { play_on(); }) {}

Player::~Player() {
  {
    const std::lock_guard lock(mutex_);
    told_.ends = true;
  }
  thread_.join();
}

void Player::hear_from(const Listener& listener) {
  const std::lock_guard lock(mutex_);
  told_.listener = listener;
}

void Player::set_volume(double volume) {
  const std::lock_guard lock(mutex_);
  told_.volume = volume;
}

void Player::chime(Chime chime) {
  const std::lock_guard lock(mutex_);
  if (told_.chimes.size() < kMostChimes) told_.chimes.push_back(chime);
}

void Player::rest() {
  const std::lock_guard lock(mutex_);
  told_.rests = true;
}

PlayedCounts Player::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void Player::play_on() {
  output_.use();
  {
    Stage stage(scene_);
    auto last = std::chrono::steady_clock::now();
    for (;;) {
      Told told;
      {
        const std::lock_guard lock(mutex_);
        told = told_;
        told_.chimes.clear();
      }
      stage.hear_from(told.listener);
      stage.set_volume(told.ends ? 0 : told.volume);
      if (told.ends) break;
      hear(stage, told.rests);
      for (const Chime chime : told.chimes) stage.chime(chime);
      const auto now = std::chrono::steady_clock::now();
      stage.turn(std::chrono::duration<double>(now - std::exchange(last, now)).count());
      measure(stage);
      std::this_thread::sleep_for(kTurn);
    }
    std::this_thread::sleep_for(kFallSilent);
  }
  Output::let_go();
}

void Player::hear(Stage& stage, bool rests) {
  std::int64_t blows = 0, late = 0;
  std::optional<Slide> slide;
  bool told = false;
  // No more than lie there now: a storm of blows that are told faster than they are played must not keep this
  // thread from its other work.
  std::size_t left = ticks_.size();
  for (TimedTick tick; left > 0 && ticks_.pop(tick); --left, told = true) {
    const Heard heard = listener_.next(tick.record);
    slide = heard.slide;
    if (!heard.blow || rests) continue;
    if (1e-9 * static_cast<double>(AgeClock::now_ns() - tick.at_ns) > kTooLate) {
      ++late;
    } else if (const auto started = stage.strike(*heard.blow)) {
      ++blows;
      unmeasured_.push_back({*started, tick.at_ns});
    }
  }
  if (rests)
    stage.slide(std::nullopt);
  else if (told)
    stage.slide(slide);
  const bool connected = output_.is_connected();
  const std::lock_guard lock(mutex_);
  counts_.blows += blows;
  counts_.late += late;
  counts_.dropped = stage.dropped();
  counts_.unplugged = !connected;
}

// Once the library has begun to mix it. What has ended by then is not known.
void Player::measure(const Stage& stage) {
  std::erase_if(
      unmeasured_,
      [&](const Measured& blow) {
        const std::int64_t now = AgeClock::now_ns();
        const double age = 1e-9 * static_cast<double>(now - blow.at_ns);
        if (const std::optional<double> after = stage.heard_after(blow.started)) {
          const double latency = age + *after;
          const std::lock_guard lock(mutex_);
          ++counts_.measured;
          counts_.latency_sum += latency;
          counts_.latency_most = std::max(counts_.latency_most, latency);
          return true;
        }
        return age > 1;
      });
}

}  // namespace fulcrum::audio
