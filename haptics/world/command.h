#pragma once
// What the main thread may ask of the tick. Commands are part of the tape.

#include <cstdint>

namespace fulcrum {

struct Command {
  enum class Kind : std::uint32_t {
    stop = 1,         // the force falls to zero and stays there
    acknowledge = 2,  // ends a stop: the force ramps in again
    watchdog = 3,     // the live loop lost ticks to a stall
  };
  Kind kind = Kind::stop;

  bool operator==(const Command&) const = default;
};

}  // namespace fulcrum
