// What a World says it is made of.

#include <cmath>

#include "haptics/actuation/vibrotactile_output.h"
#include "haptics/math/number_text.h"
#include "haptics/world/coupling_gains.h"
#include "haptics/world/world.h"

namespace fulcrum {
namespace {

// Of the stiffness that the device renders.
std::string let_go_text(const SceneDesc& desc) {
  const double limit = coupling_limits(desc).stiffness;
  if (!std::isfinite(limit)) return "";
  return "; let go, it holds up to " +
         number_text(limit * desc.mapping.position_scale * desc.mapping.force_scale) + " N/m";
}

const char* method_name(AllocationMethod method) {
  constexpr const char* names[] = {"exact", "algorithm1", "pseudoinverse"};
  return names[static_cast<int>(method)];
}

std::string reason_of(VoxelReason reason) {
  switch (reason) {
    case VoxelReason::given:
      return "as given";
    case VoxelReason::error:
      return "for the wanted error";
    case VoxelReason::thinnest_wall:
      return "for three across the thinnest wall";
    case VoxelReason::band:
      return "for two in the given band";
    case VoxelReason::memory:
      return "for want of memory, coarser than the wanted error asks";
  }
  return "";
}

BuiltPart field_part(const char* name, const DistanceField& field) {
  return {
      name,
      "distance field, " +
          (field.format() == FieldFormat::int16 ? "int16 of " + number_text(field.quantum_m() * 1e6) + " um"
                                                : std::string("float32")) +
          " in sparse bricks, " + number_text(static_cast<double>(field.bytes()) * 1e-6) + " MB, voxel " +
          number_text(field.voxel_m() * 1e3) + " mm " + reason_of(field.voxel_reason()) +
          ", error of contacts at most " + number_text(field.contact_error_m() * 1e3) +
          " mm on 95 % of the surface and " + number_text(field.error_bound_m() * 1e3) +
          " mm anywhere, thinnest wall " + number_text(field.thinnest_feature_m() * 1e3) + " mm",
      field.bytes()};
}

BuiltPart torque_part(const TorqueSubstitution& effect) {
  std::string what = "bad above " + number_text(effect.bounds().torque) + " N m and a lever of " +
                     number_text(effect.bounds().radius * 1e3) + " mm";
  if (effect.limits()) what += "; limits the coupling's torque";
  if (effect.vibrates()) what += "; vibration";
  if (effect.shows_ghost())
    what += "; ghost from " + number_text(effect.ghost_above()) + " to " + number_text(effect.ghost_below()) +
            " N m";
  return {"torque substitution", what, sizeof(TorqueSubstitution)};
}

BuiltPart impact_part(const SceneDesc& desc) {
  std::string what = "new contact regions met at " + number_text(desc.impact.least_speed * 1e3) +
                     " mm/s or more; armed again " + number_text(desc.impact.retreat * 1e3) + " mm off";
  std::size_t bytes = sizeof(ImpactDetector);
  if (desc.scene_objects) {
    what += "; which object is struck, by " + std::to_string(desc.scene_objects->size()) + " samples";
    bytes += desc.scene_objects->bytes();
  }
  return {"impacts", what, bytes};
}

BuiltPart vibration_part(const ImpactVibrationDesc& desc, const ImpactVibration& effect) {
  const ImpactSurroundings& around = effect.around();
  std::string what = desc.render == ImpactRender::wrench ? "wrench" : "torque";
  what += desc.distance == DistanceModel::beam ? ", a beam" : ", a sinusoid";
  what += " of " + number_text(around.reach * 1e3) + " mm, at most " + std::to_string(desc.voices) +
          " voices, up to " + number_text(around.highest_Hz) + " Hz;";
  for (std::size_t i = 0; i < desc.materials.size(); ++i)
    what += (i == 0 ? " " : ", ") + desc.materials[i].name + " " +
            number_text(desc.materials[i].frequency_Hz) + " Hz";
  return {"impact vibration", what, sizeof(ImpactVibration)};
}

BuiltPart pulse_part(const SceneDesc& desc, const BrakingPulse& effect) {
  const BrakingPulseDesc& pulse = effect.desc();
  const std::string what = "stops a hand of " + number_text(pulse.hand_mass) + " kg in " +
                           std::to_string(pulse.ticks) + (pulse.ticks == 1 ? " tick" : " ticks");
  return {"braking pulse",
          what + (desc.device.renders_torque
                      ? "; a moment makes up for missing force at " + number_text(pulse.p_HG.norm() * 1e3) +
                            " mm from the handle's origin"
                      : ""),
          sizeof(BrakingPulse)};
}

BuiltPart motion_part(const VibrotactileMotionDesc& desc, const DeviceDesc& device) {
  std::string what = desc.law.envelope == MotionEnvelope::linear
                         ? "linear"
                         : "logarithmic with " + number_text(desc.law.reference * 1e3) + " mm";
  what += desc.law.onset == MotionOnset::together ? ", both together" : ", one after the other";
  what += ", over " + number_text(desc.law.window * 1e3) + " mm";
  if (device.vibrotactile) {
    what += "; " + number_text(desc.strength) + " m/s^2 at " + number_text(desc.carrier_Hz) + " Hz on";
    for (const ChannelDesc& channel : device.vibrotactile->channels) {
      what += (&channel == device.vibrotactile->channels.data() ? " " : ", ") + channel.name;
      const bool rumble = channel.kind == ChannelKind::rumble;
      what +=
          rumble ? " (rumble: an amplitude alone, " : " (" + number_text(channel.rate_Hz * 1e-3) + " kHz, ";
      what += "up to " + number_text(actuator_reach(channel, desc.carrier_Hz)) + " m/s^2";
      const double rise = 1 / (ChannelOutput::kStep * channel.rate_Hz);  // s, of pcm
      if (rumble)
        what += ", " + number_text(channel.lag * 1e3) + " ms behind";
      else if (rise > 1 / desc.update_Hz)
        what += " after " + number_text(rise * 1e3) + " ms, longer than an update";
      what += ")";
    }
  }
  if (desc.use == VibrotactileUse::fallback)
    what += "; in place of the force along the line of the channels";
  else if (desc.lateral_force > 0 && device.renders_force)
    what += "; with " + number_text(desc.lateral_force) + " N";
  return {"vibrotactile motion", what, sizeof(VibrotactileMotion)};
}

BuiltPart coupling_part(const SceneDesc& desc) {
  std::string rendered =
      number_text(desc.coupling.stiffness * desc.mapping.position_scale * desc.mapping.force_scale) + " N/m";
  if (desc.device.renders_torque)
    rendered +=
        " and " + number_text(desc.coupling.angular_stiffness * desc.mapping.energy_scale()) + " N m/rad";
  return {"coupling",
          number_text(desc.coupling.stiffness) + " N/m, " + number_text(desc.coupling.angular_stiffness) +
              " N m/rad; the device renders " + rendered + let_go_text(desc),
          sizeof(VirtualCoupling)};
}

BuiltPart holding_part(const SceneDesc& desc) {
  const HoldingPointDesc& holding = *desc.holding_point;
  std::string what = "at " + number_text(holding.place * 1e3) + " mm along the stick unless it is told";
  if (moves_grip(desc.contact.response)) what += "; the coupling's spring is there";
  if (desc.device.structure) what += "; how stiff a wall can be where it touches";
  return {"holding point", what, sizeof(HoldingPoint)};
}

BuiltPart inertia_part(const InertiaCompensation& effect) {
  constexpr const char* methods[] = {"none", "arm", "acceleration"};
  std::string what = methods[static_cast<int>(effect.desc().method)];
  if (effect.desc().switchable) what += ", and can be switched";
  what += "; " + number_text(effect.figures().mass * 1e3) + " g";
  if (const AccelerationEstimator* filter = effect.filter())
    what += ", acceleration " + number_text(filter->lag() * 1e3) + " ms late, " +
            number_text(filter->noise()) + " m/s^2 of noise, up to " +
            number_text(effect.figures().largest_force) + " N and " +
            number_text(effect.desc().budget * 1e3) + " mJ";
  return {"inertia compensation", what, sizeof(InertiaCompensation)};
}

BuiltPart budget_part(const char* name, const TransientBudget& budget) {
  std::string peak;
  if (budget.peak() > 0) peak = number_text(budget.peak()) + " N";
  if (budget.peak_torque() > 0)
    peak += (peak.empty() ? "" : " and ") + number_text(budget.peak_torque()) + " N m";
  return {name,
          "over any 100 ms: peak " + peak + ", " + number_text(budget.figures().push * 1e3) +
              " ms of it to one side, " + number_text(budget.figures().energy * 1e3) + " mJ to the hand",
          sizeof(TransientBudget) + budget.bytes()};
}

std::size_t bytes_of(const Pointshell& shell) {
  return shell.size() * (2 * sizeof(Vec3) + sizeof(double));
}

}  // namespace

std::vector<BuiltPart> World::parts() const {
  const Pointshell& shell = *desc_.tool_shell;
  constexpr const char* estimators[] = {"difference", "low_pass", "adaptive_window"};
  std::vector<BuiltPart> parts{
      field_part("field", *desc_.scene_field),
      {"pointshell",
       std::to_string(shell.size()) + " points, no surface farther than " +
           number_text(shell.covering_radius_m * 1e3) + " mm from one",
       bytes_of(shell)},
      {"estimator",
       std::string("velocity by ") + estimators[static_cast<int>(desc_.velocity.kind)] + ", delay " +
           number_text(velocity_.delay() * 1e3) + " ms",
       sizeof(VelocityEstimator) + velocity_.bytes()},
      {"allocation",
       std::to_string(motors_.motors()) + " motors of " + desc_.device.name + ", " +
           method_name(desc_.allocation.method),
       sizeof(Allocator)},
      {"safety", "clamp, slew, ramp-in, stop, energy ledger, passivity control, output limit: always built",
       sizeof(Guard) + sizeof(CountedMotion) + sizeof(EnergyLedger) + sizeof(PassivityControl) +
           sizeof(OutputLimit)},
  };
  if (coupled(desc_.contact.response)) parts.insert(parts.begin() + 2, coupling_part(desc_));
  if (desc_.scene_edges) {
    const Pointshell& edges = *desc_.scene_edges;
    parts.insert(
        parts.begin() + 2,
        {{"edges", std::to_string(edges.size()) + " points on the scene's sharp edges", bytes_of(edges)},
         field_part("tool field", *desc_.tool_field)});
  }
  if (torque_substitution_) parts.push_back(torque_part(*torque_substitution_));
  if (const TransientBudget* budget = guard_.budget(TransientSource::torque_substitution))
    parts.push_back(budget_part("transient budget", *budget));
  if (impact_detector_) parts.push_back(impact_part(desc_));
  if (impact_vibration_) parts.push_back(vibration_part(*desc_.impact_vibration, *impact_vibration_));
  if (braking_pulse_) parts.push_back(pulse_part(desc_, *braking_pulse_));
  if (holding_point_) parts.push_back(holding_part(desc_));
  if (inertia_compensation_) parts.push_back(inertia_part(*inertia_compensation_));
  if (const TransientBudget* budget = guard_.budget(TransientSource::braking_pulse))
    parts.push_back(budget_part("pulse budget", *budget));
  if (vibrotactile_motion_) parts.push_back(motion_part(*desc_.vibrotactile_motion, desc_.device));
  if (const TransientBudget* budget = guard_.budget(TransientSource::impact_vibration))
    parts.push_back(budget_part("impact budget", *budget));
  const std::vector<BuiltPart> motion = motion_->parts();
  parts.insert(parts.begin() + (desc_.scene_edges ? 4 : 2), motion.begin(), motion.end());
  return parts;
}

}  // namespace fulcrum
