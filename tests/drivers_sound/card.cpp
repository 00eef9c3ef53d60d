// A sound card as a plugin of ALSA, by its SDK of external plugins: what a configuration file says of it, it
// does. `ahead`: it plays as fast as it is written to, and always has so many frames ahead; else by the
// clock. `wrong`: busy, denied or absent, when it is opened.

#include <alsa/asoundlib.h>
#include <alsa/pcm_external.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <memory>
#include <string>

namespace {

struct Card {
  snd_pcm_ioplug_t io{};
  long ahead = -1;              // frames
  long lasts = -1;              // frames, after which it is unplugged
  snd_pcm_uframes_t taken = 0;  // frames
  std::chrono::steady_clock::time_point began;
};

Card& card_of(snd_pcm_ioplug_t* io) {
  return *static_cast<Card*>(io->private_data);
}

bool unplugged(const Card& card) {
  return card.lasts >= 0 && card.taken > static_cast<snd_pcm_uframes_t>(card.lasts);
}

int start(snd_pcm_ioplug_t* io) {
  card_of(io).began = std::chrono::steady_clock::now();
  return 0;
}

int stop(snd_pcm_ioplug_t* /*io*/) {
  return 0;
}

int prepare(snd_pcm_ioplug_t* io) {
  Card& card = card_of(io);
  if (unplugged(card)) return -ENODEV;
  card.taken = 0;
  return 0;
}

snd_pcm_sframes_t played(snd_pcm_ioplug_t* io) {
  const Card& card = card_of(io);
  if (unplugged(card)) return -ENODEV;
  if (io->state != SND_PCM_STATE_RUNNING) return 0;
  const auto taken = static_cast<double>(card.taken);
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - card.began;
  const double by_clock = since.count() * io->rate;
  if (card.ahead < 0 && by_clock > taken) return -EPIPE;
  const double frames = card.ahead >= 0 ? std::max(0.0, taken - static_cast<double>(card.ahead)) : by_clock;
  return static_cast<snd_pcm_sframes_t>(static_cast<snd_pcm_uframes_t>(frames) % io->buffer_size);
}

snd_pcm_sframes_t take(snd_pcm_ioplug_t* io, const snd_pcm_channel_area_t* /*areas*/,
                       snd_pcm_uframes_t /*offset*/, snd_pcm_uframes_t size) {
  card_of(io).taken += size;
  return static_cast<snd_pcm_sframes_t>(size);
}

int put_away(snd_pcm_ioplug_t* io) {
  close(io->poll_fd);
  delete &card_of(io);
  return 0;
}

const snd_pcm_ioplug_callback_t kCallbacks = [] {
  snd_pcm_ioplug_callback_t callbacks{};
  callbacks.start = &start;
  callbacks.stop = &stop;
  callbacks.prepare = &prepare;
  callbacks.pointer = &played;
  callbacks.transfer = &take;
  callbacks.close = &put_away;
  return callbacks;
}();

struct Settings {
  long rate = 48000, channels = 2, ahead = -1, lasts = -1;
  std::string format = "S16_LE", wrong;
};

Settings read(snd_config_t* file) {
  Settings settings;
  snd_config_iterator_t at = nullptr, next = nullptr;
  snd_config_for_each(at, next, file) {
    snd_config_t* entry = snd_config_iterator_entry(at);
    const char *name = nullptr, *text = nullptr;
    long number = 0;
    if (snd_config_get_id(entry, &name) < 0) continue;
    const std::string key = name;
    if (snd_config_get_integer(entry, &number) == 0) {
      if (key == "rate") settings.rate = number;
      if (key == "channels") settings.channels = number;
      if (key == "ahead") settings.ahead = number;
      if (key == "lasts") settings.lasts = number;
    } else if (snd_config_get_string(entry, &text) == 0) {
      if (key == "format") settings.format = text;
      if (key == "wrong") settings.wrong = text;
    }
  }
  return settings;
}

int agree(snd_pcm_ioplug_t* io, const Settings& settings) {
  const auto one = [io](int what, unsigned value) {
    return snd_pcm_ioplug_set_param_list(io, what, 1, &value);
  };
  const auto range = [io](int what, unsigned least, unsigned most) {
    return snd_pcm_ioplug_set_param_minmax(io, what, least, most);
  };
  one(SND_PCM_IOPLUG_HW_ACCESS, SND_PCM_ACCESS_RW_INTERLEAVED);
  one(SND_PCM_IOPLUG_HW_FORMAT, static_cast<unsigned>(snd_pcm_format_value(settings.format.c_str())));
  one(SND_PCM_IOPLUG_HW_CHANNELS, static_cast<unsigned>(settings.channels));
  one(SND_PCM_IOPLUG_HW_RATE, static_cast<unsigned>(settings.rate));
  range(SND_PCM_IOPLUG_HW_PERIOD_BYTES, 64, 1u << 16);
  range(SND_PCM_IOPLUG_HW_BUFFER_BYTES, 1024, 1u << 20);
  return range(SND_PCM_IOPLUG_HW_PERIODS, 2, 1024);
}

}  // namespace

extern "C" {

SND_PCM_PLUGIN_DEFINE_FUNC(stand_in) {
  static_cast<void>(root);
  const Settings settings = read(conf);
  if (settings.wrong == "busy") return -EBUSY;
  if (settings.wrong == "denied") return -EACCES;
  if (settings.wrong == "absent") return -ENODEV;
  auto card = std::make_unique<Card>();
  card->ahead = settings.ahead;
  card->lasts = settings.lasts;
  card->io.version = SND_PCM_IOPLUG_VERSION;
  card->io.name = "a card that the tests bring";
  card->io.callback = &kCallbacks;
  card->io.private_data = card.get();
  card->io.poll_fd = eventfd(1, EFD_CLOEXEC);
  card->io.poll_events = POLLIN;
  const int error = snd_pcm_ioplug_create(&card->io, name, stream, mode);
  if (error < 0) {
    close(card->io.poll_fd);
    return error;
  }
  Card* const kept = card.release();
  *pcmp = kept->io.pcm;
  return agree(&kept->io, settings);
}
SND_PCM_PLUGIN_SYMBOL(stand_in)

}  // extern "C"
