#pragma once
// What a sound card plays of a run, turn by turn, without a thread and without a clock of its own.
//
// A tick's command becomes samples here, by the class that renders the WAV of the channel from the same
// commands (actuation/vibrotactile_output.h, actuation/pcm_sample.h): a run in which nothing was left out,
// doubled or filled plays the samples of its WAVs.
//
// The clocks of card and computer differ. Where the card has a millisecond or a tick more than it should,
// whichever is longer, in the mean of a second, a tick is not rendered; where it has so much less, one is
// rendered twice. Carrier and envelope go on from where they are, so that nothing jumps: what follows is felt
// a tick earlier or later. At 1 kHz and clocks 100 ppm apart that is once in 10 s.
//
// Where no tick comes in time, the channels fall silent as in a stop, within kStopFall, and the card plays
// silence until ticks come again.

#include <cstdint>
#include <vector>

#include "drivers/sound/feed_plan.h"
#include "drivers/sound/pcm.h"
#include "haptics/actuation/vibrotactile_output.h"
#include "haptics/loop/spsc_ring.h"

namespace fulcrum::sound {

// A tick, as the haptic thread tells it.
struct ToldTick {
  VibrotactileCommand command{};
  std::int64_t at_ns = 0;  // by the steady clock
};
using ToldTicks = SpscRing<ToldTick>;

// Since the beginning, over all cards that were fed.
struct FeedCounts {
  std::int64_t ticks = 0;                    // that were played
  std::int64_t left_out = 0;                 // ticks
  std::int64_t doubled = 0;                  // ticks
  std::int64_t gaps = 0;                     // times that ticks did not come in time, and later did
  std::int64_t dry = 0;                      // times that the card had nothing left to play
  double latency_sum = 0, latency_most = 0;  // s, from a tick to its first sample at the card's output
};

class SoundFeed {
public:
  // channels: of pcm, at kRate_Hz.
  SoundFeed(const VibrotactileDesc& channels, const VibrotactileSignal& signal, double tick_s,
            const FeedPlan& plan);

  // The card is another one, or the same anew: all begins from silence.
  void begin();
  // Every millisecond or so. False: the card is lost, or has taken nothing for half a second of ticks.
  bool turn(Pcm& pcm, ToldTicks& told, std::int64_t now_ns);
  // The end: what is played falls silent, and no more comes.
  void finish(Pcm& pcm);

  const FeedCounts& counts() const { return counts_; }

private:
  void fall_silent();
  bool revive(Pcm& pcm, Pcm::Fill& fill);
  void leave_out_what_is_late(const Pcm::Fill& fill, ToldTicks& told);
  void play(Pcm& pcm, Pcm::Fill& fill, const ToldTick& tick, std::int64_t now_ns);
  void hold(Pcm& pcm, Pcm::Fill& fill, std::int64_t least);
  void put(Pcm& pcm, Pcm::Fill& fill, const VibrotactileCommand& command);
  std::span<const Frame> render(const VibrotactileCommand& command);
  VibrotactileCommand hush();
  void follow(const Pcm::Fill& fill, std::int64_t now_ns);

  double tick_s_;
  FeedPlan plan_;
  std::vector<ChannelOutput> outputs_;
  std::vector<Frame> frames_;  // (longest) of the newest tick
  VibrotactileCommand newest_{};
  double fall_ = 1;     // of the newest levels, while nobody tells
  bool begun_ = false;  // a tick has come
  bool waits_ = false;  // for a tick that is late
  double mean_ = 0;     // frames ahead, over a second
  std::int64_t last_ns_ = 0;
  std::int64_t written_ = 0, played_ = 0;  // frames
  std::int64_t in_vain_ = 0;               // ticks left out since the card last played something
  FeedCounts counts_;
};

}  // namespace fulcrum::sound
