#include "drivers/sound/sound_link.h"

#include <chrono>
#include <utility>

#include "haptics/loop/age_clock.h"
#include "haptics/loop/real_time.h"
#include "haptics/math/number_text.h"

namespace fulcrum::sound {
namespace {

constexpr int kTurn_ms = 1;
constexpr int kLookAgain_ms = 250;  // between two looks for a card that is away
constexpr int kLastTurns = 200;     // in which what a card holds is played, at the end

// Ticks that a card holds at most, and some for a thread that is late.
std::size_t places(const FeedPlan& plan) {
  return static_cast<std::size_t>(static_cast<double>(plan.most) / plan.tick) + 8;
}

}  // namespace

SoundLink::SoundLink(std::unique_ptr<Pcm> pcm, Open open, const VibrotactileDesc& channels,
                     const VibrotactileSignal& signal, double tick_s)
    : open_(std::move(open)),
      told_(places(feed_plan(tick_s, pcm->figures().period))),
      feed_(channels, signal, tick_s, feed_plan(tick_s, pcm->figures().period)),
      pcm_(std::move(pcm)) {
  thread_ = std::thread([this] { play_on(); });
}

SoundLink::~SoundLink() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

void SoundLink::drive(const VibrotactileCommand& command) noexcept {
  if (!connected()) return;  // a card that is away is told nothing
  if (!told_.push({command, AgeClock::now_ns()})) no_place_.fetch_add(1, std::memory_order_relaxed);
}

FeedCounts SoundLink::counts() const {
  const std::lock_guard lock(mutex_);
  FeedCounts counts = counts_;
  counts.left_out += no_place_.load(std::memory_order_relaxed);
  return counts;
}

bool SoundLink::rest(int ms) {
  std::unique_lock lock(mutex_);
  counts_ = feed_.counts();
  return !ended_.wait_for(lock, std::chrono::milliseconds(ms), [this] { return ends_; });
}

void SoundLink::play_on() {
  ask_for_scheduling(kReaderPriority);  // where it is refused, the haptic thread has said so
  while (rest(pcm_ ? kTurn_ms : kLookAgain_ms)) {
    if (!pcm_) {
      look_again();
    } else if (!feed_.turn(*pcm_, told_, AgeClock::now_ns())) {
      connected_.store(false, std::memory_order_relaxed);
      pcm_ = nullptr;
    }
  }
  if (pcm_) play_out();
}

void SoundLink::look_again() {
  pcm_ = open_();
  ToldTick stale;
  while (told_.pop(stale)) {
  }
  if (!pcm_) return;
  feed_.begin();
  connected_.store(true, std::memory_order_relaxed);
}

void SoundLink::play_out() {
  if (!feed_.turn(*pcm_, told_, AgeClock::now_ns())) return;
  feed_.finish(*pcm_);
  for (int turn = 0; turn < kLastTurns; ++turn) {
    const Pcm::Fill fill = pcm_->fill();
    if (fill.state != Pcm::State::plays || fill.ahead <= 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(kTurn_ms));
  }
}

std::string sound_text(const FeedCounts& counts) {
  std::string text = "Sound: ";
  if (counts.ticks == 0) return text + "nothing was played.";
  text.append(number_text(1e3 * counts.latency_sum / static_cast<double>(counts.ticks), 3));
  text.append(" ms from a tick to the card's output, at most ")
      .append(number_text(1e3 * counts.latency_most, 3));
  text.append(" ms; ticks left out: ").append(std::to_string(counts.left_out));
  text.append(", doubled: ").append(std::to_string(counts.doubled));
  text.append("; gaps: ").append(std::to_string(counts.gaps));
  text.append("; the card ran dry: ").append(std::to_string(counts.dry)).append(".");
  return text;
}

}  // namespace fulcrum::sound
