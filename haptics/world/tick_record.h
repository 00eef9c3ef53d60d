#pragma once
// Everything a tick leaves behind: what the trace, the judge, the renderer and the flight recorder see.

#include <array>
#include <cstdint>
#include <optional>

#include "haptics/contact/impact.h"
#include "haptics/device/device.h"
#include "haptics/effects/effect_records.h"
#include "haptics/estimate/holding_cues.h"
#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

// Of any scene.
struct PlainRecord {
  std::int64_t tick = 0;                           // 0, 1, 2, ...; simulated time is tick * tick_s
  Pose X_WH;                                       // where the hand wants the handle, in the scene
  Pose X_WT;                                       // the tool after this tick
  Twist V_WT;                                      // of T
  Wrench coupling_F_T_W;                           // virtual coupling, on the tool
  Wrench contact_F_T_W;                            // scene, on the tool
  std::int32_t regions = 0;                        // contact regions
  double depth_max = 0;                            // m, deepest shell point by the field
  Wrench device_F_H_D;                             // commanded, on the handle
  std::array<double, kMaxMotors> actuator_load{};  // fraction of each motor's limit, signed
  Wrench missing_F_H_D;          // what was wanted, continuous or not, less what was commanded
  double energy_port = 0;        // J, passivity observer: below its bound the loop has given out energy
  double energy_unrendered = 0;  // J, brought in by turning against torque that the device does not render
  double force_gain = 0;         // 0 stopped to 1 running
  std::uint32_t faults = 0;      // bits of Fault
  bool stopped = false;          // waiting for an acknowledgement
  bool clutched = false;
  std::optional<ImpactTick> impact{};         // where impacts are detected
  std::optional<HoldingCues> holding{};       // where the scene names a holding point
  std::optional<double> contact_stiffness{};  // N/m, of a region, where the scene has levels of it
  std::optional<double>
      contact_stiffness_wanted{};  // N/m, likewise: asked for, in force once nothing touches
};

struct TickRecord : PlainRecord, EffectRecords {};

}  // namespace fulcrum
