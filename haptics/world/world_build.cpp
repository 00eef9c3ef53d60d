// What a World refuses.

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>
#include <utility>

#include "haptics/math/number_text.h"
#include "haptics/world/coupling_gains.h"
#include "haptics/world/world.h"

namespace fulcrum {
namespace {

// Of m / T^2. The coupling's part of what the tick can hold; the contact's comes on top (contact/penalty.h).
constexpr double kCouplingShare = 0.25;

// Of the coupling's largest force: what the weight may take of it where the tool has no inertia.
constexpr double kLargestSag = 0.9;

Error refuse_gain(const char* key, double given, const char* unit, double largest, double tick_s) {
  return {std::string(key) + " is " + number_text(given) + " " + unit + ", and with this tool a tick of " +
          number_text(tick_s * 1e3) + " ms can hold at most " + number_text(largest) +
          ": lower it, raise the tick rate or the tool's mass, or name the integrator implicit_euler."};
}

bool positive(double value) {
  return std::isfinite(value) && value > 0;
}

bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

std::optional<Error> refuse_mechanism(const DeviceDesc& device) {
  if (device.kinematics != Kinematics::arms) return std::nullopt;
  if (auto error = Mechanism::refuse(device.mechanism)) return error;
  const int motors = Mechanism::motors(device.mechanism);
  if (device.renders_torque != (motors >= 6))
    return Error{
        "The device '" + device.name + "' has " + std::to_string(motors) +
        " motors: with six or more it renders torque, with fewer it does not. Set renders_torque so."};
  return std::nullopt;
}

std::optional<Error> refuse_torque_substitution(const TorqueSubstitutionDesc& desc, double tick_s) {
  for (const std::optional<double>& figure :
       {desc.bad_above, desc.tool_radius, desc.reference, desc.ghost_above, desc.ghost_below}) {
    if (figure && !positive(*figure)) return Error{"The thresholds of torque_substitution must be positive."};
  }
  if (!within(desc.vibration_gain, 0, 1) || !within(desc.ghost_gain, 0, 1) || !positive(desc.ghost_fade) ||
      !(desc.amplitude >= 0) || !std::isfinite(desc.amplitude))
    return Error{
        "In torque_substitution gains must be from 0 to 1, the ghost's fade positive and the vibration's "
        "amplitude not negative."};
  // Slower, and its half waves would push the hand to and fro (safety/transient_budget.h).
  constexpr double slowest_Hz = 80;
  constexpr double samples = 2.5;  // a period; with fewer the held samples are mostly mirror tones
  if (!within(desc.frequency_Hz, slowest_Hz, 1 / (samples * tick_s)))
    return Error{"torque_substitution.vibration.frequency_Hz is " + number_text(desc.frequency_Hz) +
                 "; at this tick rate it must be from " + number_text(slowest_Hz) + " to " +
                 number_text(1 / (samples * tick_s)) + ": change it, or raise tick_rate_Hz."};
  return std::nullopt;
}

std::optional<Error> refuse_impact_vibration(const ImpactVibrationDesc& desc) {
  if (!within(desc.gain, 0, 1) || desc.voices < 1 || desc.voices > ImpactVoices::kMost ||
      !positive(desc.hand_stiffness))
    return Error{"In impact_vibration the gain must be from 0 to 1, voices from 1 to " +
                 std::to_string(ImpactVoices::kMost) + " and hand_stiffness positive."};
  if (desc.materials.empty()) return Error{"impact_vibration needs a material for what is struck."};
  for (const ImpactMaterial& material : desc.materials) {
    if (!(material.attack >= 0) || !std::isfinite(material.attack) || !positive(material.decay) ||
        !positive(material.frequency_Hz))
      return Error{"The material '" + material.name +
                   "' needs an attack that is not negative, and a positive decay and frequency_Hz."};
  }
  return std::nullopt;
}

std::optional<Error> refuse_braking_pulse(const BrakingPulseDesc& desc) {
  if (!positive(desc.hand_mass) || desc.ticks < 1 || desc.ticks > BrakingPulse::kMostTicks ||
      !within(desc.gain, 0, 1) || !desc.p_HG.allFinite())
    return Error{"In braking_pulse the hand's mass must be positive, ticks from 1 to " +
                 std::to_string(BrakingPulse::kMostTicks) + ", the gain from 0 to 1 and the grasp finite."};
  return std::nullopt;
}

std::optional<Error> refuse_channels(const DeviceDesc& device) {
  if (!device.vibrotactile) return std::nullopt;
  const std::vector<ChannelDesc>& channels = device.vibrotactile->channels;
  if (channels.size() > kMaxChannels || !device.vibrotactile->find("left") ||
      !device.vibrotactile->find("right"))
    return Error{"The device '" + device.name + "' has " + std::to_string(channels.size()) +
                 " vibrotactile channels: it needs 'left' and 'right', and may have " +
                 std::to_string(kMaxChannels) + " in all."};
  for (const ChannelDesc& channel : channels) {
    const bool known = channel.kind == ChannelKind::rumble
                           ? channel.lag >= 0 && std::isfinite(channel.lag)
                           : positive(channel.rate_Hz) && positive(channel.resonance_Hz) &&
                                 positive(channel.quality) && channel.quality > 0.5;
    if (!positive(channel.largest) || !known)
      return Error{"The vibrotactile channel '" + channel.name + "' of the device '" + device.name +
                   "' needs a positive largest acceleration; as pcm a positive rate_Hz and resonance_Hz and "
                   "a quality above 0.5, as rumble a lag that is not negative."};
  }
  return std::nullopt;
}

std::optional<Error> refuse_vibrotactile_motion(const VibrotactileMotionDesc& desc,
                                                const DeviceDesc& device) {
  if (!positive(desc.law.window) || !positive(desc.law.reference) || !positive(desc.strength) ||
      !positive(desc.update_Hz) || !positive(desc.carrier_Hz) || !within(desc.gain, 0, 1))
    return Error{
        "In vibrotactile_motion window, reference, strength, update_Hz and carrier_Hz must be positive and "
        "the gain from 0 to 1."};
  if (!desc.centre_W.allFinite() || !desc.axis_W.allFinite() || !(desc.axis_W.norm() > 0) ||
      !(desc.lateral_force >= 0) || !std::isfinite(desc.lateral_force) || !positive(desc.full_speed) ||
      !positive(desc.full_force))
    return Error{
        "In vibrotactile_motion the centre must be finite, the axis not zero, lateral_force not negative, "
        "and full_speed and full_force positive."};
  if (!device.vibrotactile) return std::nullopt;
  constexpr double samples = 2.5;  // a period; with fewer the held samples are mostly mirror tones
  for (const ChannelDesc& channel : device.vibrotactile->channels) {
    if (channel.kind == ChannelKind::pcm && desc.carrier_Hz * samples > channel.rate_Hz)
      return Error{"vibrotactile_motion.carrier_Hz is " + number_text(desc.carrier_Hz) + ", and channel '" +
                   channel.name + "' of the device '" + device.name + "' renders up to " +
                   number_text(channel.rate_Hz / samples) + " Hz: lower it."};
  }
  return std::nullopt;
}

std::optional<Error> refuse_levels(const ContactDesc& contact) {
  for (const double level : contact.levels) {
    if (!positive(level)) return Error{"The levels of contact stiffness must be positive."};
  }
  if (!contact.levels.empty() && contact.response == ContactResponse::constraint)
    return Error{
        "A constraint has no stiffness to choose: leave contact.levels out, or name another response."};
  return std::nullopt;
}

std::optional<Error> refuse_holding_point(const SceneDesc& desc) {
  const HoldingPointDesc& holding = *desc.holding_point;
  if (!holding.axis_H.allFinite() || std::abs(holding.axis_H.norm() - 1) > 1e-6)
    return Error{"The axis of holding_point must be a unit vector: the stick's direction in the handle."};
  if (!within(holding.place, holding.low, holding.high) || !std::isfinite(holding.low) ||
      !std::isfinite(holding.high))
    return Error{"holding_point.place is " + number_text(holding.place) +
                 " m and must lie on the stick, from 'low' to 'high'."};
  if (!positive(holding.speed)) return Error{"holding_point.speed must be positive."};
  if (moves_grip(desc.contact.response) && substitutes_torque(desc) &&
      desc.torque_substitution->limit_stiffness)
    return Error{
        "torque_substitution softens a coupling about the tool's centre of mass, and under this response a "
        "holding_point takes its spring to where the hand holds: set torque_substitution.limit_stiffness to "
        "false, leave one of the two out, or name another response."};
  return std::nullopt;
}

std::optional<Error> refuse_inertia_compensation(const SceneDesc& desc) {
  const InertiaCompensationDesc& inertia = *desc.inertia_compensation;
  if (inertia.method == InertiaMethod::arm && !desc.holding_point)
    return Error{
        "inertia_compensation by the method arm needs to know where the hand holds: name holding_point."};
  if (!within(inertia.gain, 0, 1) || !positive(inertia.budget))
    return Error{"In inertia_compensation the gain must be from 0 to 1 and the budget positive."};
  if (!positive(inertia.filter.jerk) || (inertia.encoder_noise && !positive(*inertia.encoder_noise)))
    return Error{"In inertia_compensation the filter's jerk and noise must be positive."};
  return std::nullopt;
}

// Held elsewhere than at its centre of mass the tool gives way more easily there, and its motions mix.
std::optional<Error> refuse_grip(const SceneDesc& desc, double smallest_inertia) {
  const Vec3 p_TG = longest_grip(desc);
  const double mass = RigidBody(desc.tool.mass, desc.tool.inertia_T).least_mass_at(p_TG);
  const double rate_squared =
      desc.coupling.stiffness / mass + desc.coupling.angular_stiffness / smallest_inertia;
  const double largest = kCouplingShare / (desc.tick_s * desc.tick_s);
  if (rate_squared <= largest) return std::nullopt;
  return Error{"Held up to " + number_text(p_TG.norm() * 1e3) +
               " mm from its centre of mass the tool can bear no more than " +
               number_text(100 * largest / rate_squared) +
               " % of the coupling's stiffness at this tick rate: lower coupling.stiffness and "
               "coupling.angular_stiffness, raise tick_rate_Hz, or name the integrator implicit_euler."};
}

}  // namespace

Result<World> World::build(SceneDesc desc) {
  if (!desc.tool_shell || desc.tool_shell->size() == 0)
    return Error{"The tool has no pointshell, so nothing could touch: give a model with the role 'tool'."};
  if (!desc.scene_field)
    return Error{
        "The scene has no distance field, so nothing could be touched: give a model with the role 'scene'."};
  if (!positive(desc.tick_s) || desc.tick_s > 0.05)
    return Error{"The tick is " + number_text(desc.tick_s) + " s; it must be above 0 and at most 0.05 s."};
  const ToolDesc& tool = desc.tool;
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(tool.inertia_T);
  const double smallest_inertia = principal.eigenvalues()[0];
  if (!positive(tool.mass) || !tool.inertia_T.allFinite() || !positive(smallest_inertia))
    return Error{
        "The tool's mass and principal moments of inertia must be positive: check its density and that its "
        "mesh encloses a volume."};
  if (!tool.X_HT.is_finite() || !tool.X_WT_start.is_finite() || !desc.mapping.X_WD.is_finite())
    return Error{"A pose of the tool or the device holds a value that is not a number."};
  if (!positive(desc.mapping.position_scale) || !positive(desc.mapping.force_scale))
    return Error{"The device's position_scale and force_scale must be positive."};
  if (!positive(desc.contact.stiffness) || !(desc.contact.dissipation >= 0) ||
      !positive(desc.contact.region_radius))
    return Error{"Contact stiffness and region radius must be positive, and dissipation not negative."};
  if (!(desc.contact.friction >= 0) || !std::isfinite(desc.contact.friction))
    return Error{"The coefficient of friction must be 0 or more."};
  if (desc.contact.friction > 0 && desc.contact.response != ContactResponse::constraint)
    return Error{
        "contact.friction is there for the response constraint alone: name that response, or leave friction "
        "out."};
  if (auto error = refuse_mechanism(desc.device)) return *error;
  if (desc.device.strip) {
    if (auto error = refuse_strip(*desc.device.strip)) return *error;
  }
  if (!positive(desc.allocation.moment_weight))
    return Error{"The weight of missing moment in the allocation must be positive."};
  if (!desc.scene_edges != !desc.tool_field)
    return Error{
        "The scene's edges need a field of the tool, and the other way about: give both or neither."};
  if (desc.scene_edges && desc.contact.response != ContactResponse::constraint)
    return Error{
        "The scene's edges are there for the response constraint alone: name that response, or leave "
        "them out."};
  if (!positive(desc.coupling.max_force) || !positive(desc.coupling.max_torque) ||
      !(desc.coupling.damping_ratio >= 0 && desc.coupling.damping_ratio <= 1))
    return Error{
        "The coupling's max_force and max_torque must be positive and its damping_ratio from 0 to 1."};
  const double rate_squared = 1.0 / (desc.tick_s * desc.tick_s);
  const bool any_gain = desc.integrator == Integrator::implicit_euler || massless(desc.contact.response);
  const double largest_k = kCouplingShare * tool.mass * rate_squared;
  if (!positive(desc.coupling.stiffness) || (!any_gain && desc.coupling.stiffness > largest_k))
    return refuse_gain("coupling.stiffness", desc.coupling.stiffness, "N/m", largest_k, desc.tick_s);
  const double largest_kr = kCouplingShare * smallest_inertia * rate_squared;
  if (!positive(desc.coupling.angular_stiffness) ||
      (!any_gain && desc.coupling.angular_stiffness > largest_kr))
    return refuse_gain("coupling.angular_stiffness", desc.coupling.angular_stiffness, "N m/rad", largest_kr,
                       desc.tick_s);
  if (desc.holding_point) {
    if (auto error = refuse_holding_point(desc)) return *error;
    if (!any_gain && moves_grip(desc.contact.response)) {
      if (auto error = refuse_grip(desc, smallest_inertia)) return *error;
    }
  }
  if (desc.inertia_compensation) {
    if (auto error = refuse_inertia_compensation(desc)) return *error;
  }
  if (auto error = refuse_levels(desc.contact)) return *error;
  if (coupled(desc.contact.response) && massless(desc.contact.response) &&
      tool_weight(tool) > kLargestSag * desc.coupling.max_force)
    return Error{"The tool weighs " + number_text(tool_weight(tool)) + " N, which a coupling of at most " +
                 number_text(desc.coupling.max_force) +
                 " N cannot carry: raise coupling.max_force or set tool.weight to false."};
  if (desc.velocity.window < 1 || desc.velocity.window > 1000 || !positive(desc.velocity.cutoff_Hz))
    return Error{"The velocity estimator's window must be 1 to 1000 ticks and its cutoff_Hz positive."};
  if (desc.torque_substitution) {
    if (auto error = refuse_torque_substitution(*desc.torque_substitution, desc.tick_s)) return *error;
  }
  if (!positive(desc.impact.retreat) || !(desc.impact.least_speed >= 0))
    return Error{"The retreat of impact must be positive, and its least_speed not negative."};
  if (desc.braking_pulse) {
    if (auto error = refuse_braking_pulse(*desc.braking_pulse)) return *error;
  }
  if (desc.impact_vibration) {
    if (auto error = refuse_impact_vibration(*desc.impact_vibration)) return *error;
  }
  if (auto error = refuse_channels(desc.device)) return *error;
  if (desc.vibrotactile_motion) {
    if (auto error = refuse_vibrotactile_motion(*desc.vibrotactile_motion, desc.device)) return *error;
  }
  return World(std::move(desc));
}

}  // namespace fulcrum
