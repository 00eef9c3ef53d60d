#pragma once
// Vibrators at a finger or in a grip, as a capability of a device: channels by name, and what each can do.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/math/names_of.h"

namespace fulcrum {

inline constexpr std::size_t kMaxChannels = 4;

enum class ChannelKind {
  rumble,  // a motor with an eccentric mass: an amplitude is all that it is told
  pcm,     // a voice coil, or an audio channel: it is told samples
  tone     // a resonant actuator with a generator of its own: the carrier's frequency, then amplitudes
};
template <>
inline constexpr std::array<std::string_view, 3> names_of<ChannelKind>{"rumble", "pcm", "tone"};

// Figures from a data sheet or measured.
struct ChannelDesc {
  std::string name;
  ChannelKind kind = ChannelKind::pcm;
  double largest = 0;       // m/s^2, amplitude at full drive; of pcm: at its resonance
  double rate_Hz = 48000;   // pcm: samples
  double resonance_Hz = 0;  // pcm
  double quality = 0;       // pcm: Q of the resonance, above 0.5
  double lag = 0;           // s, rumble and tone: time constant of the amplitude
};

// Two channels or more; `left` and `right` are those on either side, along D's x.
struct VibrotactileDesc {
  std::vector<ChannelDesc> channels;

  std::optional<std::size_t> find(std::string_view name) const {
    for (std::size_t i = 0; i < channels.size(); ++i)
      if (channels[i].name == name) return i;
    return std::nullopt;
  }
};

// What does not change as long as a scene runs.
struct VibrotactileSignal {
  double carrier_Hz = 233;
  double largest = 0;  // m/s^2, I_max: of all levels that will be asked for
};

// What the channels are to do until the next command.
struct VibrotactileCommand {
  std::array<double, kMaxChannels> level{};  // (channels) m/s^2, amplitude of the carrier
  double glide = 0;                          // s, in which the envelope goes there from where it is
  bool stopping = false;                     // within that time whatever the step: all force is being stopped
};

}  // namespace fulcrum
