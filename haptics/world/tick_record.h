#pragma once
// Everything a tick leaves behind: what the trace, the judge, the renderer and the flight recorder see.

#include <array>
#include <cstdint>
#include <optional>

#include "haptics/contact/impact.h"
#include "haptics/device/device.h"
#include "haptics/effects/effect_records.h"
#include "haptics/estimate/holding_record.h"
#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"
#include "haptics/signal/quantity.h"

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
  Wrench device_F_H_D;                             // commanded, on the handle; holds up its weight, too
  std::array<double, kMaxMotors> actuator_load{};  // fraction of each motor's limit, signed
  Wrench shortfall_F_H_D;        // what was wanted, continuous or not, less what was commanded
  double energy_port = 0;        // J, passivity observer: below its bound the loop has given out energy
  double energy_unrendered = 0;  // J, brought in by turning against torque that the device does not render
  double force_gain = 0;         // 0 stopped to 1 running
  std::uint32_t faults = 0;      // bits of Fault
  bool stopped = false;          // waiting for an acknowledgement
  bool clutched = false;
  std::optional<double> sample_age{};  // s, of the device's sample, where its rate is its own
  std::optional<ImpactTick> impact{};  // where impacts are detected
  std::optional<Vec3> drifted_W{};     // (3) m, by which drift has carried the handle on, where there is some
  std::optional<HoldingRecord> holding{};            // where the scene names a holding point
  std::optional<double> contact_stiffness{};         // N/m, of a region, where the scene has levels of it
  std::optional<double> contact_stiffness_wanted{};  // N/m, the requested contact stiffness; applied in the
                                                     // next tick without contact
};

template <class V>
void describe(V& values, const PlainRecord& record) {
  const auto& [tick, X_WH, X_WT, V_WT, coupling, contact, regions, depth_max, device, actuator_load,
               shortfall, energy_port, energy_unrendered, force_gain, faults, stopped, clutched, sample_age,
               impact, drifted_W, holding, contact_stiffness, contact_stiffness_wanted] = record;
  values.time({"timestamp", "s", "", "Simulated time, counted in ticks."}, tick);
  values.pose({"handle", "", "W", "Where the hand wants the handle H"}, X_WH);
  values.pose({"tool", "", "W", "The tool T, at its centre of mass, after this tick"}, X_WT);
  values.vector({"tool/v", "m/s", "W", "Velocity of the tool's centre of mass."}, V_WT.v);
  values.vector({"tool/w", "rad/s", "W", "Angular velocity of the tool."}, V_WT.w);
  values.wrench({"coupling", "", "W", "Virtual coupling on the tool, about T"}, coupling);
  values.wrench({"contact", "", "W", "The scene on the tool, about T"}, contact);
  values.count({"contact/regions", "1", "", "Contact regions that touch."}, regions);
  values.number({"contact/depth_max", "m", "", "Deepest point of the tool's shell, by the distance field."},
                depth_max);
  values.wrench(
      {"device", "", "D", "Commanded on the handle, about H; it holds up the handle's own weight, too"},
      device);
  values.each({"actuator/load", "1", "", "Signed fraction of this motor's limit."}, actuator_load,
              values.names().motors);
  if (values.names().motors.empty()) {
    values.unseen(shortfall);
  } else {
    values.length({"actuator/shortfall/force", "N", "",
                   "Of all that was wanted on the handle, what the motors had not."},
                  shortfall.force);
    values.length({"actuator/shortfall/torque", "N m", "",
                   "Of all that was wanted on the handle, what the motors had not; beside a pulse, what "
                   "compensates for its force too."},
                  shortfall.torque);
  }
  values.number({"energy/port", "J", "",
                 "Passivity observer, at the device: the least that the hand can have put in; below zero the "
                 "loop may have given out energy."},
                energy_port);
  values.number(
      {"energy/unrendered", "J", "", "Of energy/port, what came in on axes that the device does not render."},
      energy_unrendered);
  values.unseen(force_gain);
  values.count(
      {"fault", "1", "", "Bits of Fault: 0 to 15 stop the force, the others are limits that were applied."},
      faults);
  values.unseen(stopped);
  values.unseen(clutched);
  if (sample_age)
    values.number({"handle/age", "s", "", "Of the device's sample, since it was measured."}, *sample_age);
  if (drifted_W)
    values.vector({"handle/drift", "m", "W", "By which drift has carried the handle on in the scene."},
                  *drifted_W);
  if (contact_stiffness)
    values.number({"contact/stiffness", "N/m", "", "Of each contact region, as chosen."}, *contact_stiffness);
  if (contact_stiffness_wanted) values.unseen(*contact_stiffness_wanted);
  if (impact) describe(values, *impact);
  if (holding) describe(values, *holding);
}

struct TickRecord : PlainRecord, EffectRecords {};

template <class V>
void describe(V& values, const TickRecord& record) {
  describe(values, static_cast<const PlainRecord&>(record));
  describe(values, static_cast<const EffectRecords&>(record));
}

}  // namespace fulcrum
