#pragma once
// What a tick can report. A fault stops the force; a limit was applied and the run goes on.

#include <cstdint>
#include <span>
#include <string>

namespace fulcrum {

enum Fault : std::uint32_t {
  // Faults: the force falls to zero within 2 ms and stays there until acknowledged.
  kStopRequested = 1u << 0,  // Esc or an emergency stop
  kNotFinite = 1u << 1,      // NaN, infinity or a handle a kilometre off in the sample, or in a result: the
                             // tool stays where it was
  kSampleStale = 1u << 2,    // the sample is older than 20 ms, or 100 ms where the device has no motors
  kDeviceLost = 1u << 3,     // the device is gone
  kWatchdog = 1u << 4,       // the haptic thread stood still for a quarter of a second
  kToolInside = 1u << 5,     // the tool is deeper inside the scene than the contact model is made for
  kUnanswered = 1u << 6,     // the main thread waits too long, such as for a headset: nobody sees the scene
  // Limits: applied, counted, shown.
  kForceClamped = 1u << 16,     // the wrench's force was clamped to the device's limit
  kTorqueClamped = 1u << 17,    // the wrench's torque was clamped to the device's limit
  kSlewLimited = 1u << 18,      // the continuous wrench changed no faster than the limit
  kMotorClamped = 1u << 19,     // a motor would have saturated: all were scaled, the direction kept
  kMotionLimited = 1u << 20,    // the tool moved less than its velocity, so that no point could pass a wall
  kStiffnessCapped = 1u << 21,  // summed contact stiffness was scaled down to what the tick can hold
  kContactsReduced = 1u << 22,  // more points touched than the set holds: neighbours were taken together
  kEnergyBound = 1u << 23,      // the port gave out more energy than its bound allows
  kPassivityControl =
      1u << 24,  // the handle's motion was resisted, to take back energy that the loop had made
  kTransientLimited = 1u << 25,   // a vibration or pulse asked for more than its budget and got less
  kHoldingPointLost = 1u << 26,   // nothing trustworthy tells where the hand holds: the last place, then the
                                  // scene's own
  kCompensationFaded = 1u << 27,  // the device's inertia is felt: making up for it would add energy
  kOutputLimited =
      1u << 28,  // the command was beyond a limit that all before it should have kept, and was cut
};

inline constexpr std::uint32_t kStoppingFaults = 0x0000ffffu;
// Of them those in which neither device nor hand does anything wrong: who follows a path waits.
inline constexpr std::uint32_t kPausingFaults = kStopRequested | kUnanswered;
// The faults stop the force, and all of them are such.
inline bool is_pause(std::uint32_t faults) {
  return (faults & kPausingFaults) != 0 && (faults & kStoppingFaults & ~kPausingFaults) == 0;
}

struct FaultName {
  Fault bit;
  const char* name;      // as in summary.json
  const char* sentence;  // what a person is told
};

// Every bit, in the order above.
std::span<const FaultName> fault_names();

}  // namespace fulcrum
