// FNV-1a (draft-eastlake-fnv-17), a 64-bit word at a time instead of an octet, each followed by a fold of the
// high half into the low one: a product carries upwards only, and without the fold the low bits would never
// see the high.
#include "engine/record/digest.h"

#include <bit>
#include <concepts>

namespace fulcrum::record {

namespace {

class Fnv {
public:
  void add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x100000001b3u;
    hash_ ^= hash_ >> 32;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& v) {
    for (const double component : v) {
      add(component);
    }
  }
  void add(const Quat& q) {
    add(q.w());
    add(Vec3(q.vec()));
  }
  void add(const Pose& X) {
    add(X.q);
    add(X.p);
  }
  void add(const Twist& V) {
    add(V.v);
    add(V.w);
  }
  void add(const Wrench& F) {
    add(F.force);
    add(F.torque);
  }
  void add(std::integral auto value) { add(static_cast<std::uint64_t>(value)); }

  std::uint64_t hash() const { return hash_; }

private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t digest(const TickRecord& record) {
  // A field that is added to TickRecord does not compile here until it is added to this list.
  const auto& [tick, X_WH, X_WT, V_WT, coupling, contact, regions, depth_max, device, actuator_load, missing,
               energy_port, energy_unrendered, force_gain, faults, stopped, clutched, impact, holding,
               contact_stiffness, contact_stiffness_wanted] = static_cast<const PlainRecord&>(record);
  const auto& [torque, impact_vibration, pulse, vibrotactile, inertia] =
      static_cast<const EffectRecords&>(record);
  Fnv fnv;
  fnv.add(tick);
  fnv.add(X_WH);
  fnv.add(X_WT);
  fnv.add(V_WT);
  fnv.add(coupling);
  fnv.add(contact);
  fnv.add(regions);
  fnv.add(depth_max);
  fnv.add(device);
  for (const double load : actuator_load) {
    fnv.add(load);
  }
  fnv.add(energy_port);
  fnv.add(energy_unrendered);
  fnv.add(force_gain);
  fnv.add(faults);
  fnv.add(stopped);
  fnv.add(clutched);
  fnv.add(torque.bad);
  for (const double value : {torque.magnitude, torque.stiffness, torque.vibration, torque.ghost,
                             torque.vibration_gain, torque.ghost_gain, torque.energy}) {
    fnv.add(value);
  }
  // Nothing of what is not there: a scene without it keeps the digests of its tapes.
  if (!missing.is_zero()) fnv.add(missing);
  if (impact) {
    fnv.add(impact->count);
    fnv.add(impact->hardest.p_W);
    fnv.add(impact->hardest.nhat_W);
    fnv.add(impact->hardest.speed);
    fnv.add(impact->hardest.object);
  }
  if (impact_vibration) {
    const auto& [gain, voices, dropped, frequency_Hz, radius, axis_W, amplitude_D, F_H_D, energy] =
        *impact_vibration;
    fnv.add(voices);
    fnv.add(dropped);
    for (const double value : {gain, frequency_Hz, radius, energy}) {
      fnv.add(value);
    }
    fnv.add(axis_W);
    fnv.add(amplitude_D);
    fnv.add(F_H_D);
  }
  if (pulse) {
    const auto& [gain, moment, wanted_F_H_D, F_H_D, force_share, moment_share, energy, moment_energy] =
        *pulse;
    fnv.add(moment);
    fnv.add(wanted_F_H_D);
    fnv.add(F_H_D);
    for (const double value : {gain, force_share, moment_share, energy, moment_energy}) {
      fnv.add(value);
    }
  }
  if (vibrotactile) {
    const auto& [gain, command, missing_level, x, direction, force] = *vibrotactile;
    for (const double level : command.level) {
      fnv.add(level);
    }
    fnv.add(command.stopping);
    fnv.add(direction);
    for (const double value : {gain, command.glide, missing_level, x, force}) {
      fnv.add(value);
    }
  }
  if (holding) {
    const auto& [place, p_HG, state, strip_ohm, limit] = *holding;
    fnv.add(p_HG);
    fnv.add(static_cast<std::int32_t>(state));
    for (const double value : {place, strip_ohm, limit}) {
      fnv.add(value);
    }
  }
  if (inertia) {
    const auto& [method, gain, faded, acceleration_D, force_D, torque_D, energy, arm_energy] = *inertia;
    fnv.add(static_cast<std::int32_t>(method));
    fnv.add(faded);
    fnv.add(acceleration_D);
    fnv.add(force_D);
    fnv.add(torque_D);
    for (const double value : {gain, energy, arm_energy}) {
      fnv.add(value);
    }
  }
  if (contact_stiffness) fnv.add(*contact_stiffness);
  if (contact_stiffness_wanted) fnv.add(*contact_stiffness_wanted);
  return fnv.hash();
}

}  // namespace fulcrum::record
