#pragma once
// A haptic device, as the tick sees it: a sample in, a command out.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "haptics/device/holding_strip.h"
#include "haptics/device/mechanism_desc.h"
#include "haptics/device/structure.h"
#include "haptics/device/vibrotactile_desc.h"
#include "haptics/math/names_of.h"
#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

inline constexpr std::size_t kMaxMotors = 8;

// What the device knew at one moment. D: device base, H: handle.
struct DeviceSample {
  Pose X_DH;                    // handle pose
  double age = 0;               // s since the pose was measured
  std::uint32_t buttons = 0;    // bit n: button n is down
  bool connected = true;        // false: the device is lost and the pose is the last one known
  double strip_ohm = kNoStrip;  // of the strip that knows where the hand holds; kStripOpen: nothing presses
};

// What the device is to do until the next command.
struct DeviceCommand {
  Wrench F_H_D;                             // wrench on the handle about H, in D, that the motors add up to
  std::array<double, kMaxMotors> effort{};  // (motors) N or N m at each motor

  // What else the person is told, for a device that can tell it in its own way, and for a simulated hand.
  struct Cues {
    double vibration = 0;          // N, amplitude of the tone that is in F_H_D
    double ghost = 0;              // 0 to 1, how plainly the turn below is seen
    Vec3 unwind_D = Vec3::Zero();  // (3) rad, the turn that would take the handle back to the tool
    // (3) m in W, by which the mapping has drifted: whoever sees the tool holds the handle so much back.
    Vec3 drifted_W = Vec3::Zero();
    bool paused = false;  // the force is off since somebody asked for it: whoever follows a path waits
  };
  Cues cues{};
  VibrotactileCommand vibrotactile{};  // where the device has channels
};

enum class Kinematics {
  none,       // no motors: a mouse
  cartesian,  // a motor for each force axis, and for each torque axis where torque is rendered
  arms        // as `mechanism` says
};
template <>
inline constexpr std::array<std::string_view, 3> names_of<Kinematics>{"none", "cartesian", "arms"};

// The device's figures, from its data sheet or measured. They bound what safety lets through; a scenario
// cannot change them.
struct DeviceDesc {
  std::string name = "simulated";
  Kinematics kinematics = Kinematics::cartesian;
  bool renders_force = true;
  bool renders_torque = false;
  bool senses_rotation = true;
  double max_force = 7.9;                        // N
  double max_torque = 0;                         // N m
  double handle_mass = 0.072;                    // kg, apparent, at the handle
  Vec3 handle_inertia = Vec3::Constant(2.0e-5);  // (3) kg m^2, apparent, about the axes of the handle
  double handle_weight = 0.3;  // N, what the mechanism leaves uncompensated; the tick holds it up
  double bandwidth_Hz = 500;   // of forces and torques that it renders
  double damping = 0.005;      // N s/m
  Vec3 angular_damping = Vec3::Constant(2.0e-5);  // (3) N m s, about each axis
  double friction = 0.038;                        // N, Coulomb, each axis
  double angular_friction = 2.0e-4;               // N m, Coulomb, each axis
  double encoder_step = 28e-6;                    // m
  double encoder_step_rad = 2.0e-4;               // rad
  double sample_rate_Hz = 0;                      // of a device that has its own; 0: a sample for each tick
  double firmware_watchdog = 0;  // s without a command after which its firmware lets go; 0: none is known
  Vec3 workspace{0.080, 0.060, 0.060};             // (3) m, half extents
  Vec3 workspace_centre = Vec3::Zero();            // (3) m, in D; a table has it at D's origin
  MechanismDesc mechanism{};                       // of arms
  std::optional<StructureDesc> structure{};        // where it is known
  std::optional<VibrotactileDesc> vibrotactile{};  // its channels, where it has such
  std::optional<HoldingStripDesc> strip{};         // along the handle
};

// Drivers implement this. read() and write() are called from the haptic thread, in turn, once a tick.
// May: copy the newest state out of a buffer; queue a report. Must not: block, allocate, lock, throw.
class Device {
public:
  virtual ~Device() = default;
  virtual const DeviceDesc& desc() const = 0;
  virtual DeviceSample read() noexcept = 0;
  virtual void write(const DeviceCommand& command) noexcept = 0;
  // n ticks passed in which nothing was written (an overrun): the held command decays, see held_fraction().
  virtual void miss(int ticks) noexcept = 0;
};

// What is left of a command that was written `age` s ago, 0 to 1. A force that is held through a stall makes
// energy: at 60 ms only 17.5 N/m would be stable. It is held for two ticks of 1 kHz, then falls to nothing
// within 5 ms.
double held_fraction(double age);
// What a device does by then of such a command: its wrench and its efforts. Nothing vibrates.
DeviceCommand held_command(const DeviceCommand& command, double age);

}  // namespace fulcrum
