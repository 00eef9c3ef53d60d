#pragma once
// Sound cards as the registry and `fulcrum doctor` use them.

#include <memory>
#include <string>

#include "drivers/sound/alsa_pcm.h"
#include "drivers/sound/sound_link.h"
#include "haptics/math/result.h"

namespace fulcrum::sound {

// Errors: the channels are none that a card could play, or the card cannot be had.
Result<std::unique_ptr<SoundLink>> open_sound(const SoundPlace& place, const VibrotactileDesc& channels,
                                              const VibrotactileSignal& signal, double tick_s);

// Where the voice coils of a DualSense are. Errors: none is plugged in.
Result<SoundPlace> dualsense_coils();

// Why two channels could not be played there, or why there is no such place; empty: they can.
std::string why_no_sound(const Result<SoundPlace>& place);

// What two channels would find there with ticks of that length: "HDA Intel PCH: ... 8 ms ...". It plays
// nothing.
Result<std::string> describe_sound(const SoundPlace& place, double tick_s);

}  // namespace fulcrum::sound
