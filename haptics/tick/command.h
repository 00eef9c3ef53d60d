#pragma once
// What the main thread may ask of the tick. Commands are part of the tape.

#include <algorithm>
#include <cstdint>

namespace fulcrum {

struct Command {
  enum class Kind : std::uint32_t {
    stop = 1,                // the force falls to zero and stays there
    acknowledge = 2,         // ends a stop: the force ramps in again
    watchdog = 3,            // the live loop lost ticks to a stall
    vibration_gain = 4,      // of the vibration that tells of torque: value 0 (off) to 1
    ghost_gain = 5,          // of the ghost: 0 (off) to 1
    impact_gain = 6,         // of the vibration at impacts: 0 (off) to 1
    pulse_gain = 7,          // of the braking pulse: 0 (off) to 1
    pulse_moment = 8,        // whether its moment makes up for missing force: 0 or 1
    vibrotactile_gain = 9,   // of the vibrotactile motion, 0 (off) to 1
    hold_at = 10,            // where the hand holds the stick: m from the handle's origin along it
    hold_measured = 11,      // whether that is measured: 0 or 1
    contact_stiffness = 12,  // N/m, of each region: the level that is nearest
    compensation = 13,       // of the device's inertia: 0 none, 1 arm, 2 acceleration
    caught_up = 14,          // the live loop: this tick and the value - 1 after it come at once, late
    texture_gain = 15,       // of a texture, 0 (off) to 1
    guidance_gain = 16,      // of guidance, 0 (off) to 1
    release = 17,            // the force ramps out as it ramped in, and then is stopped
    unanswered = 18,         // the live loop: the main thread waits too long for something; as stop
    last = unanswered
  };
  Kind kind = Kind::stop;
  double value = 0;  // what it is set to; 0 where there is nothing to set

  // A gain, 0 to 1; what is no number is 0.
  double gain() const { return value > 0 ? std::min(value, 1.0) : 0.0; }

  bool operator==(const Command&) const = default;
};

}  // namespace fulcrum
