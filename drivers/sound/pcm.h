#pragma once
// A sound card that is open, as the thread that feeds it sees it. Nothing here waits.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum::sound {

inline constexpr int kRate_Hz = 48000;

// (channels) in the order of the device's table; what is beyond them is not looked at.
using Frame = std::array<std::int16_t, kMaxChannels>;

// What was agreed with the card.
struct PcmFigures {
  std::string card;         // its name
  std::int64_t period = 0;  // frames, in which it takes what it plays
  std::int64_t buffer = 0;  // frames that it holds at most
};

class Pcm {
public:
  enum class State {
    plays,
    dry,  // it had nothing left to play, and waits for restart()
    lost
  };
  struct Fill {
    State state = State::plays;
    std::int64_t ahead = 0;  // frames that will be played before the next one written
    std::int64_t room = 0;   // frames that write() can take
  };

  virtual ~Pcm() = default;  // silent from then on, whatever it holds
  virtual Fill fill() = 0;
  // frames: no more than its room. What goes wrong is seen by the next fill().
  virtual void write(std::span<const Frame> frames) = 0;
  // Empty again, to play from the next frame on. False: it is lost.
  virtual bool restart() = 0;
  virtual const PcmFigures& figures() const = 0;
};

}  // namespace fulcrum::sound
