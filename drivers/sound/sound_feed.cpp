#include "drivers/sound/sound_feed.h"

#include <algorithm>

#include "haptics/actuation/pcm_sample.h"
#include "haptics/safety/guard.h"

namespace fulcrum::sound {
namespace {

constexpr double kMeanOver = 1;   // s
constexpr double kInVain = 0.5;   // s of ticks that a card did not take: its clock stands still
constexpr double kLeastOff = 48;  // frames, 1 ms, off the aim that are let be

}  // namespace

SoundFeed::SoundFeed(const VibrotactileDesc& channels, const VibrotactileSignal& signal, double tick_s,
                     const FeedPlan& plan)
    : tick_s_(tick_s), plan_(plan), frames_(static_cast<std::size_t>(plan.longest) + 1) {
  for (const ChannelDesc& channel : channels.channels) outputs_.emplace_back(channel, signal, tick_s);
  begin();
}

void SoundFeed::begin() {
  fall_silent();
  begun_ = waits_ = false;
  mean_ = static_cast<double>(plan_.aim);
  last_ns_ = written_ = played_ = in_vain_ = 0;
}

bool SoundFeed::turn(Pcm& pcm, ToldTicks& told, std::int64_t now_ns) {
  Pcm::Fill fill = pcm.fill();
  if (fill.state == Pcm::State::dry && !revive(pcm, fill)) return false;
  if (fill.state != Pcm::State::plays) return false;
  if (written_ - fill.ahead > played_) in_vain_ = 0;
  played_ = written_ - fill.ahead;

  if (written_ == 0) hold(pcm, fill, plan_.aim);
  leave_out_what_is_late(fill, told);
  if (static_cast<double>(in_vain_) * tick_s_ > kInVain) return false;
  ToldTick tick;
  while (fill.room >= 2 * plan_.longest && told.pop(tick)) play(pcm, fill, tick, now_ns);

  hold(pcm, fill, begun_ ? plan_.floor : plan_.aim);
  follow(fill, now_ns);
  return true;
}

void SoundFeed::hold(Pcm& pcm, Pcm::Fill& fill, std::int64_t least) {
  while (fill.ahead < least && fill.room >= plan_.longest) {
    waits_ = true;
    put(pcm, fill, hush());
  }
}

// Of what no card plays.
void SoundFeed::fall_silent() {
  fall_ = 0;
  while (std::ranges::any_of(outputs_, [](const ChannelOutput& output) { return output.envelope() > 0; }))
    render(hush());
}

// What was on its way when the card ran dry is late by now. The channels begin anew from silence.
bool SoundFeed::revive(Pcm& pcm, Pcm::Fill& fill) {
  fall_silent();
  if (!pcm.restart()) return false;
  ++counts_.dry;
  fill = pcm.fill();
  written_ = played_ = 0;
  return true;
}

void SoundFeed::leave_out_what_is_late(const Pcm::Fill& fill, ToldTicks& told) {
  const double ahead = static_cast<double>(fill.ahead) + static_cast<double>(told.size()) * plan_.tick;
  if (ahead <= static_cast<double>(plan_.most)) return;
  ToldTick tick;
  for (double over = ahead - static_cast<double>(plan_.aim); over > 0 && told.pop(tick); over -= plan_.tick) {
    ++counts_.left_out;
    ++in_vain_;
  }
}

// A stop is never left out of what is played for the sake of the clocks, nor made longer.
void SoundFeed::play(Pcm& pcm, Pcm::Fill& fill, const ToldTick& tick, std::int64_t now_ns) {
  const double off = std::max(kLeastOff, plan_.tick);
  if (waits_ && begun_) ++counts_.gaps;
  begun_ = true;
  waits_ = false;
  fall_ = 1;
  newest_ = tick.command;
  if (!tick.command.stopping && mean_ > static_cast<double>(plan_.aim) + off) {
    ++counts_.left_out;
    mean_ -= plan_.tick;
    return;
  }
  const double latency =
      1e-9 * static_cast<double>(now_ns - tick.at_ns) + static_cast<double>(fill.ahead) / kRate_Hz;
  counts_.latency_sum += latency;
  counts_.latency_most = std::max(counts_.latency_most, latency);
  ++counts_.ticks;
  put(pcm, fill, tick.command);
  if (tick.command.stopping || mean_ >= static_cast<double>(plan_.aim) - off) return;
  ++counts_.doubled;
  mean_ += plan_.tick;
  put(pcm, fill, tick.command);
}

void SoundFeed::put(Pcm& pcm, Pcm::Fill& fill, const VibrotactileCommand& command) {
  const std::span<const Frame> frames = render(command);
  if (frames.empty()) return;
  pcm.write(frames);
  const auto count = static_cast<std::int64_t>(frames.size());
  fill.ahead += count;
  fill.room -= count;
  written_ += count;
}

std::span<const Frame> SoundFeed::render(const VibrotactileCommand& command) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const std::span<const double> drives = outputs_[i].process(command.level[i], command);
    count = std::min(drives.size(), frames_.size());
    for (std::size_t k = 0; k < count; ++k) frames_[k][i] = pcm_sample(drives[k]);
  }
  return std::span(frames_).first(count);
}

VibrotactileCommand SoundFeed::hush() {
  fall_ = std::max(0.0, fall_ - tick_s_ / kStopFall);
  VibrotactileCommand command = newest_;
  for (double& level : command.level) level *= fall_;
  command.glide = std::min(tick_s_, kStopFall);
  command.stopping = true;
  return command;
}

void SoundFeed::follow(const Pcm::Fill& fill, std::int64_t now_ns) {
  const double passed = last_ns_ == 0 ? 0 : 1e-9 * static_cast<double>(now_ns - last_ns_);
  last_ns_ = now_ns;
  if (waits_ || !begun_) return;
  mean_ += std::min(1.0, passed / kMeanOver) * (static_cast<double>(fill.ahead) - mean_);
}

void SoundFeed::finish(Pcm& pcm) {
  Pcm::Fill fill = pcm.fill();
  while (fill.state == Pcm::State::plays && fill.room >= plan_.longest) {
    put(pcm, fill, hush());
    if (fall_ == 0) return;
  }
}

}  // namespace fulcrum::sound
