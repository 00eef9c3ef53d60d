#include "drivers/sound/alsa_pcm.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "haptics/math/number_text.h"

namespace fulcrum::sound {
namespace {

constexpr snd_pcm_uframes_t kPeriod = 96;  // frames, 2 ms

struct Close {
  void operator()(snd_pcm_t* pcm) const {
    snd_pcm_drop(pcm);
    snd_pcm_close(pcm);
  }
};
using Handle = std::unique_ptr<snd_pcm_t, Close>;

constexpr std::array<snd_pcm_format_t, 3> kFormats{SND_PCM_FORMAT_S16, SND_PCM_FORMAT_S32,
                                                   SND_PCM_FORMAT_FLOAT};

// ALSA writes to stderr what our sentences say.
void say_nothing(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                 const char* /*format*/, ...) {}

Error why_not_opened(const std::string& name, int error) {
  switch (-error) {
    case EBUSY:
      return Error{
          "another program plays on it: end that one, or name a PCM that mixes, such as audio:default."};
    case EACCES:
    case EPERM:
      return Error{
          "you may not open it: log in at the machine itself, or have root add you to the group audio."};
    default:
      if (name == "default")
        return Error{"no sound card is there: plug one in; `cat /proc/asound/cards` lists those that are."};
      return Error{"ALSA knows no PCM '" + name + "', or its card is not there (" + snd_strerror(error) +
                   "): `cat /proc/asound/cards` lists the cards; audio:hw:1,0 is the first PCM of card 1."};
  }
}

// The rates from here to there that the card has.
std::string rates_text(snd_pcm_hw_params_t* params) {
  unsigned least = 0, most = 0;
  snd_pcm_hw_params_get_rate_min(params, &least, nullptr);
  snd_pcm_hw_params_get_rate_max(params, &most, nullptr);
  return least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
}

struct Agreed {
  snd_pcm_format_t format = SND_PCM_FORMAT_S16;
  unsigned channels = 0;
  snd_pcm_uframes_t period = 0, buffer = 0;
};

// channels: that are needed at least; those beyond get silence.
Result<Agreed> agree(snd_pcm_t* pcm, unsigned channels, snd_pcm_uframes_t buffer) {
  snd_pcm_hw_params_t* params = nullptr;
  snd_pcm_hw_params_alloca(&params);
  Agreed agreed;
  if (snd_pcm_hw_params_any(pcm, params) < 0 ||
      snd_pcm_hw_params_set_access(pcm, params, SND_PCM_ACCESS_RW_INTERLEAVED) < 0)
    return Error{"it cannot be written to in the usual way: name another PCM."};
  snd_pcm_hw_params_set_rate_resample(pcm, params, 0);
  if (snd_pcm_hw_params_set_rate(pcm, params, kRate_Hz, 0) < 0)
    return Error{"it does not play " + std::to_string(kRate_Hz) + " samples a second, but " +
                 rates_text(params) + ": name another PCM, such as audio:default."};
  const auto format = std::ranges::find_if(
      kFormats, [&](snd_pcm_format_t f) { return snd_pcm_hw_params_set_format(pcm, params, f) == 0; });
  if (format == kFormats.end())
    return Error{"it takes samples of neither 16 nor 32 bits: name another PCM, such as audio:default."};
  agreed.format = *format;
  unsigned most = 0;
  snd_pcm_hw_params_get_channels_min(params, &agreed.channels);
  snd_pcm_hw_params_get_channels_max(params, &most);
  agreed.channels = std::max(agreed.channels, channels);
  if (snd_pcm_hw_params_set_channels(pcm, params, agreed.channels) < 0)
    return Error{"it has " + std::to_string(most) + " channels, and " + std::to_string(channels) +
                 " are needed: name another PCM."};
  agreed.period = kPeriod;
  agreed.buffer = buffer;
  if (snd_pcm_hw_params_set_period_size_near(pcm, params, &agreed.period, nullptr) < 0 ||
      snd_pcm_hw_params_set_buffer_size_near(pcm, params, &agreed.buffer) < 0 ||
      snd_pcm_hw_params(pcm, params) < 0)
    return Error{"it refused its own settings: plug it in again, or name another PCM."};
  return agreed;
}

// It begins with the first frame, and stops where it has none.
bool begin_at_once(snd_pcm_t* pcm) {
  snd_pcm_sw_params_t* params = nullptr;
  snd_pcm_sw_params_alloca(&params);
  return snd_pcm_sw_params_current(pcm, params) == 0 &&
         snd_pcm_sw_params_set_start_threshold(pcm, params, 1) == 0 && snd_pcm_sw_params(pcm, params) == 0;
}

std::string card_name(snd_pcm_t* pcm, const std::string& name) {
  snd_pcm_info_t* info = nullptr;
  snd_pcm_info_alloca(&info);
  char* card = nullptr;
  if (snd_pcm_info(pcm, info) < 0 || snd_pcm_info_get_card(info) < 0 ||
      snd_card_get_name(snd_pcm_info_get_card(info), &card) < 0)
    return name;
  std::string text = card;
  std::free(card);
  return text;
}

class AlsaPcm final : public Pcm {
public:
  AlsaPcm(Handle pcm, const Agreed& agreed, const SoundPlace& place, std::size_t channels)
      : pcm_(std::move(pcm)),
        agreed_(agreed),
        first_(place.first),
        channels_(channels),
        figures_{card_name(pcm_.get(), place.pcm), static_cast<std::int64_t>(agreed.period),
                 static_cast<std::int64_t>(agreed.buffer)} {}

  Fill fill() override {
    snd_pcm_sframes_t room = 0, ahead = 0;
    const int error = snd_pcm_avail_delay(pcm_.get(), &room, &ahead);
    if (error == -EPIPE || error == -ESTRPIPE) return {.state = State::dry};
    if (error < 0) return {.state = State::lost};
    return {State::plays, std::max<std::int64_t>(ahead, 0), std::max<std::int64_t>(room, 0)};
  }

  void write(std::span<const Frame> frames) override {
    const std::size_t frame_bytes = agreed_.channels * bytes_of_sample();
    bytes_.assign(frames.size() * frame_bytes, 0);
    for (std::size_t f = 0; f < frames.size(); ++f)
      for (std::size_t c = 0; c < channels_; ++c)
        put(frames[f][c], bytes_.data() + f * frame_bytes + (first_ + c) * bytes_of_sample());
    std::size_t done = 0;
    while (done < frames.size()) {
      const auto taken = snd_pcm_writei(pcm_.get(), bytes_.data() + done * frame_bytes, frames.size() - done);
      if (taken <= 0) return;
      done += static_cast<std::size_t>(taken);
    }
  }

  bool restart() override {
    if (snd_pcm_state(pcm_.get()) == SND_PCM_STATE_SUSPENDED) snd_pcm_resume(pcm_.get());
    return snd_pcm_prepare(pcm_.get()) == 0;
  }

  const PcmFigures& figures() const override { return figures_; }

private:
  std::size_t bytes_of_sample() const { return agreed_.format == SND_PCM_FORMAT_S16 ? 2 : 4; }

  void put(std::int16_t sample, std::uint8_t* to) const {
    const std::int32_t wide = std::int32_t{sample} * 65536;
    const float real = static_cast<float>(sample) / 32768;
    if (agreed_.format == SND_PCM_FORMAT_S16) std::memcpy(to, &sample, sizeof sample);
    if (agreed_.format == SND_PCM_FORMAT_S32) std::memcpy(to, &wide, sizeof wide);
    if (agreed_.format == SND_PCM_FORMAT_FLOAT) std::memcpy(to, &real, sizeof real);
  }

  Handle pcm_;
  Agreed agreed_;
  std::size_t first_, channels_;
  PcmFigures figures_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

Result<std::unique_ptr<Pcm>> open_alsa(const SoundPlace& place, std::size_t channels, std::int64_t ahead) {
  snd_lib_error_set_handler(&say_nothing);
  snd_pcm_t* opened = nullptr;
  const int error = snd_pcm_open(&opened, place.pcm.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
  if (error < 0) return why_not_opened(place.pcm, error);
  Handle pcm(opened);
  const Result<Agreed> agreed =
      agree(pcm.get(), place.first + static_cast<unsigned>(channels), static_cast<snd_pcm_uframes_t>(ahead));
  if (!agreed) return agreed.error();
  if (!begin_at_once(pcm.get()))
    return Error{"it refused its own settings: plug it in again, or name another PCM."};
  return std::unique_ptr<Pcm>(std::make_unique<AlsaPcm>(std::move(pcm), *agreed, place, channels));
}

}  // namespace fulcrum::sound
