#include "engine/record/trace_columns.h"

#include <nlohmann/json.hpp>

#include "engine/record/number_text.h"
#include "engine/record/whole_rate.h"

namespace fulcrum::record {

namespace {

using Columns = std::vector<TraceColumn>;

struct What {
  std::string name, unit, frame, meaning;
};

template <class Read>  // TraceValue-like (const TickRecord&)
void add(Columns& columns, const What& what, Read read) {
  columns.push_back({what.name, what.unit, what.frame, what.meaning,
                     [read](const TraceRow& row) { return TraceValue(read(row.record)); }});
}

template <class Read>  // const Vec3& (const TickRecord&)
void add_vector(Columns& columns, const What& what, Read read) {
  constexpr const char* axes[] = {"/x", "/y", "/z"};
  for (int i = 0; i < 3; ++i) {
    add(columns, {what.name + axes[i], what.unit, what.frame, what.meaning},
        [read, i](const TickRecord& record) { return read(record)[i]; });
  }
}

template <class Read>  // const Pose& (const TickRecord&)
void add_pose(Columns& columns, const What& what, Read read) {
  add_vector(columns, {what.name + "/p", "m", what.frame, what.meaning + ": position."},
             [read](const TickRecord& record) -> const Vec3& { return read(record).p; });
  constexpr const char* parts[] = {"/q/w", "/q/x", "/q/y", "/q/z"};
  for (int i = 0; i < 4; ++i) {
    add(columns, {what.name + parts[i], "1", what.frame, what.meaning + ": orientation, unit quaternion."},
        [read, i](const TickRecord& record) {
          const Quat& q = read(record).q;
          return i == 0 ? q.w() : q.vec()[i - 1];
        });
  }
}

template <class Read>  // const Wrench& (const TickRecord&)
void add_wrench(Columns& columns, const What& what, Read read) {
  add_vector(columns, {what.name + "/force", "N", what.frame, what.meaning + ": force."},
             [read](const TickRecord& record) -> const Vec3& { return read(record).force; });
  add_vector(columns, {what.name + "/torque", "N m", what.frame, what.meaning + ": torque."},
             [read](const TickRecord& record) -> const Vec3& { return read(record).torque; });
}

void add_torque_substitution(Columns& c) {
  add(c, {"torque/bad", "1", "", "1 while no force that the hand feels can tell of the torque."},
      [](const TickRecord& record) { return std::int64_t{record.torque.bad}; });
  add(c, {"torque/magnitude", "N m", "", "Of the torque that the coupling's full stiffness gives, about T."},
      [](const TickRecord& record) { return record.torque.magnitude; });
  add(c, {"torque/stiffness", "N m/rad", "", "The coupling's torque over the angle between hand and tool."},
      [](const TickRecord& record) { return record.torque.stiffness; });
  add(c, {"cue/vibration", "N", "", "Amplitude of the vibration that tells of torque."},
      [](const TickRecord& record) { return record.torque.vibration; });
  add(c, {"cue/ghost", "1", "", "Opacity of the ghost, 0 to 1."},
      [](const TickRecord& record) { return record.torque.ghost; });
  add(c, {"cue/vibration_gain", "1", "", "What the vibration is set to; 0: off."},
      [](const TickRecord& record) { return record.torque.vibration_gain; });
  add(c, {"cue/ghost_gain", "1", "", "What the ghost is set to; 0: off."},
      [](const TickRecord& record) { return record.torque.ghost_gain; });
}

void add_impacts(Columns& c, bool objects) {
  add(c, {"impact/count", "1", "", "Impacts in this tick."},
      [](const TickRecord& record) { return std::int64_t{record.impact->count}; });
  add(c,
      {"impact/speed", "m/s", "", "Of the hand towards the scene at the hardest of them; 0: there was none."},
      [](const TickRecord& record) { return record.impact->hardest.speed; });
  if (objects)
    add(c, {"impact/object", "1", "", "Which of the scene's models it struck, from 0; -1: there was none."},
        [](const TickRecord& record) {
          return std::int64_t{record.impact->count > 0 ? record.impact->hardest.object : -1};
        });
  add_vector(c, {"impact/p", "m", "W", "Where it was; zero: there was none."},
             [](const TickRecord& record) -> const Vec3& { return record.impact->hardest.p_W; });
  add_vector(c, {"impact/normal", "1", "W", "The scene's normal there, towards the tool."},
             [](const TickRecord& record) -> const Vec3& { return record.impact->hardest.nhat_W; });
}

void add_impact_vibration(Columns& c) {
  add(c, {"vibration/gain", "1", "", "What the vibration at impacts is set to; 0: off."},
      [](const TickRecord& record) { return record.impact_vibration->gain; });
  add(c, {"vibration/voices", "1", "", "Vibrations that sound together."},
      [](const TickRecord& record) { return std::int64_t{record.impact_vibration->voices}; });
  add(c, {"vibration/dropped", "1", "", "Vibrations so far that were dropped for stronger ones."},
      [](const TickRecord& record) { return std::int64_t{record.impact_vibration->dropped}; });
  add(c, {"vibration/frequency_Hz", "Hz", "", "Of the newest vibration; 0: there was none yet."},
      [](const TickRecord& record) { return record.impact_vibration->frequency_Hz; });
  add(c, {"vibration/radius", "m", "", "From the handle to the impact that it tells of."},
      [](const TickRecord& record) { return record.impact_vibration->radius; });
  add_vector(c, {"vibration/axis", "1", "W", "About which it turns; zero where it pushes alone."},
             [](const TickRecord& record) -> const Vec3& { return record.impact_vibration->axis_W; });
  add_wrench(c, {"vibration/amplitude", "", "D", "Of the newest vibration, at its onset"},
             [](const TickRecord& record) -> const Wrench& { return record.impact_vibration->amplitude_D; });
  add_wrench(c, {"vibration", "", "D", "All of them together, as commanded on the handle, about H"},
             [](const TickRecord& record) -> const Wrench& { return record.impact_vibration->F_H_D; });
}

void add_vibrotactile_motion(Columns& c, const std::vector<std::string>& channels) {
  if (!channels.empty())
    add(c, {"touch/gain", "1", "", "What vibrotactile motion is set to; 0: off."},
        [](const TickRecord& record) { return record.vibrotactile->gain; });
  for (std::size_t i = 0; i < channels.size() && i < kMaxChannels; ++i) {
    add(c, {"touch/" + channels[i], "m/s^2", "", "Amplitude that this channel is told to go to."},
        [i](const TickRecord& record) { return record.vibrotactile->command.level[i]; });
  }
  if (!channels.empty()) {
    add(c,
        {"touch/missing", "m/s^2", "",
         "The most that a channel was asked for beyond what it can, in amplitude."},
        [](const TickRecord& record) { return record.vibrotactile->missing; });
    add(c, {"touch/glide", "s", "", "In which the channels go to their amplitudes."},
        [](const TickRecord& record) { return record.vibrotactile->command.glide; });
  }
  add(c, {"touch/x", "m", "", "Along the axis of the sweep, from its centre; as a fallback, in the window."},
      [](const TickRecord& record) { return record.vibrotactile->x; });
  add(c, {"touch/direction", "1", "", "Of the sweep along the axis, -1 or 1; 0: at rest."},
      [](const TickRecord& record) { return std::int64_t{record.vibrotactile->direction}; });
  add(c, {"touch/force", "N", "", "Wanted along the axis, on the handle, before safety."},
      [](const TickRecord& record) { return record.vibrotactile->force; });
}

void add_braking_pulse(Columns& c) {
  add(c, {"pulse/gain", "1", "", "What the braking pulse is set to; 0: off."},
      [](const TickRecord& record) { return record.pulse->gain; });
  add(c, {"pulse/moment", "1", "", "1 while a moment may make up for missing force."},
      [](const TickRecord& record) { return std::int64_t{record.pulse->moment}; });
  add_wrench(c, {"pulse/wanted", "", "D", "That would stop the hand, on the handle, about H"},
             [](const TickRecord& record) -> const Wrench& { return record.pulse->wanted_F_H_D; });
  add_wrench(c, {"pulse", "", "D", "Commanded of it"},
             [](const TickRecord& record) -> const Wrench& { return record.pulse->F_H_D; });
  add(c, {"pulse/force_share", "1", "", "Of the wanted force, gamma; 0: none was wanted."},
      [](const TickRecord& record) { return record.pulse->force_share; });
  add(c, {"pulse/moment_share", "1", "", "Of the moment that the hand would feel by the whole force."},
      [](const TickRecord& record) { return record.pulse->moment_share; });
}

void add_holding_point(Columns& c) {
  add(c, {"holding/place", "m", "", "Where the hand holds the stick, along it from the handle's origin."},
      [](const TickRecord& record) { return record.holding->place; });
  add(c,
      {"holding/state", "1", "",
       "Where that comes from: 0 set, 1 measured, 2 the last that was trusted, 3 on its way to the "
       "scenario's, 4 the scenario's for want of any other."},
      [](const TickRecord& record) { return static_cast<std::int64_t>(record.holding->state); });
  add(c,
      {"holding/strip_ohm", "ohm", "",
       "Of the strip under the hand; inf: nothing presses on it, nan: there is none."},
      [](const TickRecord& record) { return record.holding->strip_ohm; });
  add(c,
      {"holding/limit", "N/m", "",
       "The stiffest wall that the device's structure renders where the tool touches; 0: nothing "
       "touches, or how stiff the device is, is not known."},
      [](const TickRecord& record) { return record.holding->limit; });
}

void add_inertia_compensation(Columns& c) {
  add(c, {"inertia/method", "1", "", "0 none, 1 arm, 2 acceleration."},
      [](const TickRecord& record) { return static_cast<std::int64_t>(record.inertia->method); });
  add(c, {"inertia/gain", "1", "", "Of the device's mass times acceleration, in use."},
      [](const TickRecord& record) { return record.inertia->gain; });
  add_vector(c, {"inertia/acceleration", "m/s^2", "D", "Of the handle, as estimated."},
             [](const TickRecord& record) -> const Vec3& { return record.inertia->acceleration_D; });
  add_vector(c, {"inertia/force", "N", "D", "Commanded on the handle for the device's inertia."},
             [](const TickRecord& record) -> const Vec3& { return record.inertia->force_D; });
  add_vector(c, {"inertia/torque", "N m", "D", "What the method arm adds to the torque on the handle."},
             [](const TickRecord& record) -> const Vec3& { return record.inertia->torque_D; });
}

}  // namespace

TraceColumns::TraceColumns(double tick_s, std::span<const std::string> motors, Extras extras)
    : tick_s_(tick_s) {
  Columns& c = columns_;
  add(c, {"timestamp", "s", "", "Simulated time, counted in ticks."},
      [tick_s, rate = whole_rate(tick_s)](const TickRecord& record) {
        const auto tick = static_cast<double>(record.tick);
        return rate ? tick / *rate : tick * tick_s;
      });
  add_pose(c, {"handle", "", "W", "Where the hand wants the handle H"},
           [](const TickRecord& record) -> const Pose& { return record.X_WH; });
  add_pose(c, {"tool", "", "W", "The tool T, at its centre of mass, after this tick"},
           [](const TickRecord& record) -> const Pose& { return record.X_WT; });
  add_vector(c, {"tool/v", "m/s", "W", "Velocity of the tool's centre of mass."},
             [](const TickRecord& record) -> const Vec3& { return record.V_WT.v; });
  add_vector(c, {"tool/w", "rad/s", "W", "Angular velocity of the tool."},
             [](const TickRecord& record) -> const Vec3& { return record.V_WT.w; });
  add_wrench(c, {"coupling", "", "W", "Virtual coupling on the tool, about T"},
             [](const TickRecord& record) -> const Wrench& { return record.coupling_F_T_W; });
  add_wrench(c, {"contact", "", "W", "The scene on the tool, about T"},
             [](const TickRecord& record) -> const Wrench& { return record.contact_F_T_W; });
  add(c, {"contact/regions", "1", "", "Contact regions that touch."},
      [](const TickRecord& record) { return std::int64_t{record.regions}; });
  add(c, {"contact/depth_max", "m", "", "Deepest point of the tool's shell, by the distance field."},
      [](const TickRecord& record) { return record.depth_max; });
  add_wrench(c, {"device", "", "D", "Commanded on the handle, about H"},
             [](const TickRecord& record) -> const Wrench& { return record.device_F_H_D; });
  for (std::size_t i = 0; i < motors.size() && i < kMaxMotors; ++i) {
    add(c, {"actuator/load/" + motors[i], "1", "", "Signed fraction of this motor's limit."},
        [i](const TickRecord& record) { return record.actuator_load[i]; });
  }
  if (!motors.empty()) {
    add(c,
        {"actuator/missing/force", "N", "", "Of all that was wanted on the handle, what the motors had not."},
        [](const TickRecord& record) { return record.missing_F_H_D.force.norm(); });
    add(c,
        {"actuator/missing/torque", "N m", "", "Likewise; beside a pulse, what makes up for its force too."},
        [](const TickRecord& record) { return record.missing_F_H_D.torque.norm(); });
  }
  c.push_back({"task/step", "1", "",
               "The checkpoint that is next, from 0; the number of them once all are done.",
               [](const TraceRow& row) { return TraceValue(std::int64_t{row.task_step}); }});
  if (extras.hard_touches) {
    c.push_back({"task/hard_touches", "1", "", "Touches so far that were harder than the task allows.",
                 [](const TraceRow& row) { return TraceValue(row.hard_touches); }});
  }
  add(c,
      {"energy/port", "J", "",
       "Passivity observer, at the device: the least that the hand can have put in; below zero the loop may "
       "have given out "
       "energy."},
      [](const TickRecord& record) { return record.energy_port; });
  add(c,
      {"energy/unrendered", "J", "", "Of energy/port, what came in on axes that the device does not render."},
      [](const TickRecord& record) { return record.energy_unrendered; });
  if (extras.transients)
    add(c, {"energy/vibration", "J", "", "What the vibration has given to the hand since the start."},
        [](const TickRecord& record) { return record.torque.energy; });
  if (extras.impact_vibration)
    add(c,
        {"energy/impact_vibration", "J", "",
         "What the vibration at impacts has given to the hand since the start."},
        [](const TickRecord& record) { return record.impact_vibration->energy; });
  if (extras.braking_pulse) {
    add(c,
        {"energy/pulse", "J", "",
         "What the force of braking pulses has given to the hand; below zero: taken."},
        [](const TickRecord& record) { return record.pulse->energy; });
    add(c, {"energy/moment", "J", "", "What their torque has given to the hand, likewise."},
        [](const TickRecord& record) { return record.pulse->moment_energy; });
  }
  if (extras.inertia_compensation)
    add(c,
        {"energy/inertia", "J", "",
         "What compensation gave, less what is in the handle's motion and what damping has taken."},
        [](const TickRecord& record) { return record.inertia->energy; });
  if (extras.inertia_compensation)
    add(c,
        {"energy/arm", "J", "",
         "What the torque of the method arm gave to the hand, forgotten over a second."},
        [](const TickRecord& record) { return record.inertia->arm_energy; });
  if (extras.torque_substitution) add_torque_substitution(c);
  if (extras.impacts) add_impacts(c, extras.impact_vibration);  // which alone asks what was struck
  if (extras.impact_vibration) add_impact_vibration(c);
  if (extras.braking_pulse) add_braking_pulse(c);
  if (extras.vibrotactile_motion) add_vibrotactile_motion(c, extras.channels);
  if (extras.stiffness_levels)
    add(c, {"contact/stiffness", "N/m", "", "Of each contact region, as chosen."},
        [](const TickRecord& record) { return *record.contact_stiffness; });
  if (extras.holding_point) add_holding_point(c);
  if (extras.inertia_compensation) add_inertia_compensation(c);
  add(c,
      {"fault", "1", "", "Bits of Fault: 0 to 15 stop the force, the others are limits that were applied."},
      [](const TickRecord& record) { return std::int64_t{record.faults}; });
}

std::string TraceColumns::header() const {
  std::string line;
  for (const TraceColumn& column : columns_) {
    line += column.name;
    line += ',';
  }
  line.back() = '\n';
  return line;
}

void TraceColumns::append_row(std::string& to, const TraceRow& row) const {
  for (const TraceColumn& column : columns_) {
    std::visit([&to](auto value) { append_number(to, value); }, column.value(row));
    to += ',';
  }
  to.back() = '\n';
}

std::string TraceColumns::json() const {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const TraceColumn& column : columns_) {
    columns.push_back({{"name", column.name},
                       {"unit", column.unit},
                       {"frame", column.frame.empty() ? nullptr : nlohmann::ordered_json(column.frame)},
                       {"meaning", column.meaning}});
  }
  const nlohmann::ordered_json document = {{"version", 1}, {"tick_s", tick_s_}, {"columns", columns}};
  return document.dump(2) + '\n';
}

}  // namespace fulcrum::record
