#include "drivers/sound/sound.h"

#include <algorithm>
#include <utility>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/sound/usb_card.h"
#include "haptics/math/number_text.h"

namespace fulcrum::sound {
namespace {

constexpr std::int64_t kLongPeriod = 1024;  // frames; a card may not grant a shorter one
constexpr unsigned kCoils = 2;              // of a DualSense's four channels, the first of the two

std::string ms_text(std::int64_t frames) {
  return number_text(1e3 * static_cast<double>(frames) / kRate_Hz, 3) + " ms";
}

std::optional<Error> refuse_channels(const VibrotactileDesc& channels) {
  for (const ChannelDesc& channel : channels.channels)
    if (channel.kind != ChannelKind::pcm || channel.rate_Hz != kRate_Hz)
      return Error{"its channel '" + channel.name + "' is not of the kind pcm at " +
                   std::to_string(kRate_Hz) +
                   " Hz, which is what a sound card is given: set both in its file of content/devices."};
  return std::nullopt;
}

// The least that a card of this period needs is more than it holds.
std::optional<Error> refuse_buffer(const PcmFigures& figures, double tick_s) {
  const FeedPlan plan = feed_plan(tick_s, figures.period);
  const std::int64_t needed = plan.aim + 3 * plan.longest;
  if (figures.buffer >= needed) return std::nullopt;
  return Error{"it holds " + ms_text(figures.buffer) + " at most, and ticks of " + number_text(1e3 * tick_s) +
               " ms need " + ms_text(needed) + ": raise tick_rate_Hz, or name another PCM."};
}

Result<std::unique_ptr<Pcm>> open_pcm(const SoundPlace& place, std::size_t channels, double tick_s) {
  const FeedPlan plan = feed_plan(tick_s, kLongPeriod);
  Result<std::unique_ptr<Pcm>> pcm = open_alsa(place, channels, plan.most + 3 * plan.longest);
  if (!pcm) return pcm;
  if (auto refused = refuse_buffer((*pcm)->figures(), tick_s)) return *refused;
  return pcm;
}

}  // namespace

Result<std::unique_ptr<SoundLink>> open_sound(const SoundPlace& place, const VibrotactileDesc& channels,
                                              const VibrotactileSignal& signal, double tick_s) {
  if (auto refused = refuse_channels(channels)) return *refused;
  const std::size_t count = channels.channels.size();
  Result<std::unique_ptr<Pcm>> pcm = open_pcm(place, count, tick_s);
  if (!pcm) return pcm.error();
  const auto again = [place, count, tick_s]() -> std::unique_ptr<Pcm> {
    Result<std::unique_ptr<Pcm>> found = open_pcm(place, count, tick_s);
    return found ? std::move(*found) : nullptr;
  };
  return std::make_unique<SoundLink>(std::move(*pcm), again, channels, signal, tick_s);
}

Result<SoundPlace> dualsense_coils() {
  const std::optional<int> card = find_usb_card("/proc/asound", dualsense::usb_ids());
  if (!card)
    return Error{
        "none is plugged in: its voice coils are a sound card by USB, and by Bluetooth they are not there."};
  return SoundPlace{"hw:" + std::to_string(*card) + ",0", kCoils};
}

std::string why_no_sound(const Result<SoundPlace>& place) {
  if (!place) return place.error().sentence;
  const Result<std::unique_ptr<Pcm>> pcm = open_alsa(*place, 2, kRate_Hz / 10);
  return pcm ? "" : pcm.error().sentence;
}

Result<std::string> describe_sound(const SoundPlace& place, double tick_s) {
  const Result<std::unique_ptr<Pcm>> pcm = open_pcm(place, 2, tick_s);
  if (!pcm) return pcm.error();
  const PcmFigures& figures = (*pcm)->figures();
  std::string text = figures.card;
  text.append(": ").append(ms_text(feed_plan(tick_s, figures.period).aim));
  text.append(" from a tick to its output, with periods of ").append(ms_text(figures.period));
  text.append(" and a buffer of ").append(ms_text(figures.buffer)).append(".");
  return text;
}

}  // namespace fulcrum::sound
