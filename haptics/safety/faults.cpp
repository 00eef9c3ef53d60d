#include "haptics/safety/faults.h"

namespace fulcrum {

std::span<const FaultName> fault_names() {
  static constexpr FaultName names[] = {
      {kStopRequested, "stop_requested", "Stop was asked for."},
      {kNotFinite, "not_finite",
       "The device or the simulation gave a value that is not a number, or that no handle can have."},
      {kSampleStale, "sample_stale",
       "The device has sent nothing for more than 20 ms, or 100 ms where it has no motors."},
      {kDeviceLost, "device_lost", "The device is gone: plug it in again, and switch it on."},
      {kWatchdog, "watchdog", "The haptic thread stood still for a quarter of a second or more."},
      {kToolInside, "tool_inside",
       "The tool is deeper inside the scene than the contact model can push it out of."},
      {kUnanswered, "unanswered",
       "The program waited too long for another one, such as a headset's runtime or the display."},
      {kForceClamped, "force_clamped", "The force was limited to what the device may give."},
      {kTorqueClamped, "torque_clamped", "The torque was limited to what the device may give."},
      {kSlewLimited, "slew_limited", "The force changed no faster than the limit."},
      {kMotorClamped, "motor_clamped", "A motor reached its limit and the force was scaled down."},
      {kMotionLimited, "motion_limited", "The tool was slowed so that it could not pass a wall."},
      {kStiffnessCapped, "stiffness_capped", "Contact stiffness was lowered to what the tick can hold."},
      {kContactsReduced, "contacts_reduced",
       "More points touched than are kept; neighbours were taken together."},
      {kEnergyBound, "energy_bound", "The haptic loop gave out more energy than its bound allows."},
      {kPassivityControl, "passivity_control",
       "The motion was resisted, to take back energy that the loop had made."},
      {kTransientLimited, "transient_limited", "A vibration was held to what transients may do."},
      {kHoldingPointLost, "holding_point_lost",
       "The strip did not tell where the hand holds; the last place was used, then the scenario's."},
      {kCompensationFaded, "compensation_faded",
       "Making up for the device's inertia would have added energy, so that it was faded out."},
      {kOutputLimited, "output_limited",
       "A command beyond the device's limits was cut before it was sent. Please report it, with the tape."},
  };
  return names;
}

}  // namespace fulcrum
