#pragma once
// A sound card by ALSA.

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/sound/pcm.h"
#include "haptics/math/result.h"

namespace fulcrum::sound {

// Where channels are played.
struct SoundPlace {
  std::string pcm = "default";  // as ALSA names it: default, hw:1,0
  unsigned first = 0;           // the card's channel that the first of the device's goes to
};

// channels: of the device. ahead: frames that are to find room. Nothing converts rates: the card plays
// kRate_Hz, 16 bit, 32 bit or float. Errors: it cannot be had, with what would cure it.
Result<std::unique_ptr<Pcm>> open_alsa(const SoundPlace& place, std::size_t channels, std::int64_t ahead);

}  // namespace fulcrum::sound
