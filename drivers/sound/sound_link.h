#pragma once
// Voice coils on a sound card, between the haptic thread and the card: the haptic thread leaves each tick's
// command in a ring and goes on; a thread of the link's own renders and plays them, a millisecond at a time.
// Where the card is unplugged, it is looked for until it is back.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "drivers/sound/sound_feed.h"
#include "drivers/vibrating/vibrator.h"

namespace fulcrum::sound {

class SoundLink final : public Vibrator {
public:
  // Null where the card is not there.
  using Open = std::function<std::unique_ptr<Pcm>()>;

  // pcm: not null, with room for feed_plan(tick_s)'s aim. channels: of pcm, at kRate_Hz.
  SoundLink(std::unique_ptr<Pcm> pcm, Open open, const VibrotactileDesc& channels,
            const VibrotactileSignal& signal, double tick_s);
  ~SoundLink() override;  // it falls silent; then the thread ends
  SoundLink(const SoundLink&) = delete;
  SoundLink& operator=(const SoundLink&) = delete;

  // The haptic thread.
  bool connected() noexcept override { return connected_.load(std::memory_order_relaxed); }
  void drive(const VibrotactileCommand& command) noexcept override;

  // Any thread but the haptic one: what was played so far. Ticks for which there was no place in the ring
  // count as left out.
  FeedCounts counts() const;

private:
  void play_on();
  void look_again();
  void play_out();
  bool rest(int ms);  // false: it is to end

  Open open_;
  ToldTicks told_;
  SoundFeed feed_;  // the thread's own
  std::atomic<bool> connected_{true};
  std::atomic<std::int64_t> no_place_{0};

  mutable std::mutex mutex_;  // of the thread below and of others; never the haptic thread's
  std::condition_variable ended_;
  bool ends_ = false;
  FeedCounts counts_;
  std::unique_ptr<Pcm> pcm_;  // the thread's own; null while the card is away
  std::thread thread_;
};

// "Sound: 8.2 ms from a tick to the card's output, ...", as a run says it at its end.
std::string sound_text(const FeedCounts& counts);

}  // namespace fulcrum::sound
