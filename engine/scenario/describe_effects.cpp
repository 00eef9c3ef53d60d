#include <algorithm>

#include "engine/scenario/describe.h"

namespace fulcrum::scenario {

namespace {

constexpr Range kTorque = above_to(0, 100);

void describe_vibration(KeyVisitor& visitor, TorqueSubstitutionDesc& effect) {
  visitor.number({"gain", "", "of the amplitude, while it is on"}, effect.vibration_gain, kFraction);
  visitor.number({"amplitude", "N", "at the handle, at the coupling's largest torque"}, effect.amplitude,
                 from_to(0, 100));
  visitor.number({"frequency_Hz", "", "of the tone"}, effect.frequency_Hz, from_to(80, 500));
  visitor.optional_number({"reference", "N m",
                           "below it the amplitude grows in proportion to the torque, above with its "
                           "logarithm; without it bad_above"},
                          effect.reference, kTorque);
}

void describe_ghost(KeyVisitor& visitor, TorqueSubstitutionDesc& effect) {
  visitor.number({"gain", "", "of the opacity, while it is on"}, effect.ghost_gain, kFraction);
  visitor.optional_number({"above", "N m", "of torque it appears; without it at twice bad_above"},
                          effect.ghost_above, kTorque);
  visitor.optional_number({"below", "N m", "of torque it leaves; without it at 0.6 of 'above'"},
                          effect.ghost_below, kTorque);
  visitor.rule("below",
               !effect.ghost_above || !effect.ghost_below || *effect.ghost_below < *effect.ghost_above,
               "must be smaller than 'above'");
  visitor.number({"fade", "s", "from nothing to the whole"}, effect.ghost_fade, above_to(0, 10));
}

void describe_torque_substitution(KeyVisitor& visitor, TorqueSubstitutionDesc& effect) {
  visitor.choice_of(
      {"variant", "", "which cues are on at the start: A none, B vibration, C vibration and ghost"},
      effect.variant);
  visitor.optional_number(
      {"bad_above", "N m", "of torque it can be bad; without it a tenth of the coupling's largest"},
      effect.bad_above, kTorque);
  visitor.optional_number({"tool_radius", "m",
                           "a torque that a force at this lever explains is good; without it the tool's "
                           "reach from its centre of mass"},
                          effect.tool_radius, above_to(0, 10));
  visitor.boolean({"limit_stiffness", "",
                   "the coupling is softened in rotation while torque is bad and contact has springs"},
                  effect.limit_stiffness);
  visitor.mapping(
      {"vibration", "", "of the handle, while torque is bad"},
      [&](KeyVisitor& inner) { describe_vibration(inner, effect); });
  visitor.mapping({"ghost", "", "of the tool, turned as the hand is, while torque is large"},
                  [&](KeyVisitor& inner) { describe_ghost(inner, effect); });
  const auto is_left_below = [&effect] {
    const TorqueThresholds thresholds = torque_thresholds(effect, 0);
    return thresholds.ghost_below < thresholds.ghost_above;
  };
  visitor.rule("ghost", !effect.bad_above || is_left_below(),
               "needs a 'below' that is smaller than 'above', which is twice bad_above unless it is given");
}

void describe_impact(KeyVisitor& visitor, ImpactDetectorDesc& impact) {
  visitor.number({"retreat", "m", "from the scene, after which a place can be struck again"}, impact.retreat,
                 above_to(0, 1));
  visitor.number({"least_speed", "m/s", "of approach; slower is no impact"}, impact.least_speed,
                 from_to(0, 10));
}

void describe_impact_vibration(KeyVisitor& visitor, Scenario& scenario) {
  ImpactVibrationDesc& effect = scenario.effects.impact_vibration.emplace();
  visitor.choice_of({"render", "", "wrench: the blow's force and its moment; torque: the moment alone"},
                    effect.render);
  visitor.choice_of(
      {"distance", "",
       "how the distance from the hand is told; beam: by the modes of a clamped beam; sinusoid: "
       "by a tone that falls"},
      effect.distance);
  visitor.number({"gain", "", "of the amplitude; 0: off at the start"}, effect.gain, kFraction);
  auto voices = static_cast<std::int64_t>(effect.voices);
  visitor.integer({"voices", "", "that sound together at most; one more drops the weakest"}, voices, 1,
                  static_cast<std::int64_t>(ImpactVoices::kMax));
  effect.voices = static_cast<std::size_t>(voices);
  visitor.number({"hand_stiffness", "N m/rad", "of the hand that is to turn by 0.02 rad at most"},
                 effect.hand_stiffness, above_to(0, 100));
  scenario.impact_material = "steel";
  visitor.word({"material", "", "of models that name none: content/materials/MATERIAL.yaml"},
               scenario.impact_material);
}

void describe_braking_pulse(KeyVisitor& visitor, BrakingPulseDesc& effect) {
  std::optional<double> hand, body;
  visitor.optional_number({"hand_mass", "kg", "of hand and handle, that the pulse is to stop"}, hand,
                          above_to(0, 1000));
  visitor.optional_number({"body_weight", "kg", "instead: the hand is 0.6 % of it; with neither it is 75 kg"},
                          body, above_to(0, 1000));
  visitor.rule("body_weight", !(hand && body), "and 'hand_mass' exclude each other; keep one of them");
  if (hand) effect.hand_mass = *hand;
  if (body) effect.hand_mass = BrakingPulse::kHandOfBody * *body;
  std::int64_t ticks = effect.ticks;
  visitor.integer({"ticks", "", "that the pulse lasts, the paper's N"}, ticks, 1, BrakingPulse::kMaxTicks);
  effect.ticks = static_cast<int>(ticks);
  visitor.vector({"grasp", "m", "where the hand holds the handle, in the handle's frame"}, effect.p_HG,
                 kPosition);
  visitor.boolean({"moment", "", "a moment makes up for missing force, at the start"}, effect.moment);
  visitor.number({"gain", "", "of the force; 0: off at the start"}, effect.gain, kFraction);
}

void describe_vibrotactile_motion(KeyVisitor& visitor, VibrotactileMotionDesc& effect) {
  visitor.choice_of({"as", "",
                     "sweep: past a centre of the scene; fallback: in place of the force along the channels' "
                     "line, on a device that cannot push"},
                    effect.use);
  visitor.choice_of({"law", "", "how levels follow the place"}, effect.law.envelope);
  visitor.choice_of(
      {"onset", "",
       "of the two vibrators; asynchronous: the second 0.32 T + 0.0473 s after the first, T the "
       "time that the finger needs for the window"},
      effect.law.onset);
  visitor.number({"window", "m", "in which the phantom goes from one vibrator to the other"},
                 effect.law.window, above_to(0, 1));
  visitor.number({"reference", "m", "of the logarithmic law: the shorter, the fuller half way"},
                 effect.law.reference, above_to(0, 1000));
  visitor.number({"strength", "m/s^2", "of the vibration at its strongest"}, effect.strength,
                 above_to(0, 1000));
  visitor.number({"update_Hz", "", "of the levels; above 0.2 m/s they are updated every tick"},
                 effect.update_Hz, from_to(1, 10000));
  visitor.number({"carrier_Hz", "", "of the vibration"}, effect.carrier_Hz, from_to(20, 1000));
  visitor.number({"gain", "", "of the vibration; 0: off at the start, and lateral_force with it"},
                 effect.gain, kFraction);
  visitor.vector({"centre", "m", "sweep: where the window begins, in the scene"}, effect.centre_W, kPosition);
  visitor.vector({"axis", "", "sweep: to the right of the finger, in the scene"}, effect.axis_W,
                 from_to(-1, 1));
  visitor.number({"lateral_force", "N", "sweep: at the handle, against it, on a device that pushes"},
                 effect.lateral_force, from_to(0, 100));
  visitor.number({"full_speed", "m/s", "from which on that force is whole"}, effect.full_speed,
                 above_to(0, 10));
  visitor.number({"full_force", "N", "fallback: for which the vibration is at its strongest"},
                 effect.full_force, above_to(0, 1000));
}

constexpr Range kAlong = from_to(-1, 1);  // m, along a stick

void describe_holding_point(KeyVisitor& visitor, HoldingPointDesc& holding) {
  visitor.vector({"axis", "", "the stick's direction in the handle's frame; of any length"}, holding.axis_H,
                 kPosition);
  visitor.rule("axis", holding.axis_H.norm() > 0, "must not be zero");
  holding.axis_H.normalize();
  visitor.number({"place", "m",
                  "where the hand holds, along the stick from the handle's origin, unless more "
                  "is known"},
                 holding.place, kAlong);
  visitor.number({"low", "m", "along the stick from the handle's origin, one end of where it can be held"},
                 holding.low, kAlong);
  visitor.number(
      {"high", "m", "along the stick from the handle's origin, the other end of where it can be held"},
      holding.high, kAlong);
  visitor.rule("place", holding.low <= holding.place && holding.place <= holding.high,
               "must be from 'low' to 'high'");
  visitor.boolean({"measured", "", "at the start, by the device's strip"}, holding.measured);
  visitor.number({"speed", "m/s", "the fastest that the point moves, whatever is told or measured"},
                 holding.speed, above_to(0, 10));
  visitor.number({"keep", "s", "for which the last trusted place is kept once the strip tells nothing"},
                 holding.keep, from_to(0, 60));
  visitor.number({"fade", "s", "in which the point then goes to 'place'"}, holding.fade, above_to(0, 60));
}

void describe_inertia_compensation(KeyVisitor& visitor, InertiaCompensationDesc& effect) {
  visitor.choice_of({"method", "",
                     "at the start; arm: the torque of a force at the hand; acceleration: mass times "
                     "acceleration on top"},
                    effect.method);
  visitor.boolean({"switchable", "", "to the other methods while running"}, effect.switchable);
  visitor.number({"gain", "", "of mass times acceleration; 0: off"}, effect.gain, kFraction);
  visitor.number({"budget", "J", "that it may give; beyond, it fades"}, effect.budget, above_to(0, 1));
  visitor.mapping({"filter", "", "acceleration from position, by a Kalman filter"}, [&](KeyVisitor& inner) {
    inner.choice_of({"kind", "", "kalman: three states; adaptive: four, expects as much jerk as it sees"},
                    effect.filter.kind);
    inner.number({"jerk", "", "m/s^3 per root Hz, that it expects"}, effect.filter.jerk, above_to(0, 1e6));
    inner.optional_number({"noise", "m", "rms, of positions; without it that of the device's encoder"},
                          effect.encoder_noise, above_to(0, 0.1));
  });
}

void describe_texture(KeyVisitor& visitor, TextureDesc& effect) {
  visitor.number({"wavelength", "m", "from ridge to ridge"}, effect.wavelength, above_to(0, 1));
  visitor.number({"height", "m", "of a ridge over the smooth surface"}, effect.height, from_to(0, 1));
  visitor.vector({"direction", "", "across the ridges, in the scene; of any length"}, effect.direction_W,
                 kPosition);
  visitor.rule("direction", effect.direction_W.norm() > 0, "must not be zero");
  visitor.number({"gain", "", "of the force; 0: off at the start"}, effect.gain, kFraction);
}

void describe_workspace_walls(KeyVisitor& visitor, WorkspaceWallsDesc& effect) {
  visitor.optional_number({"margin", "m",
                           "at the device, how far before the workspace's end they begin; without it a "
                           "fifth of its smallest half extent"},
                          effect.margin, above_to(0, 1));
  visitor.optional_number({"stiffness", "N/m", "at the device; without it, what suits the device"},
                          effect.stiffness, above_to(0, 1e5));
}

void describe_guidance(KeyVisitor& visitor, GuidanceDesc& effect) {
  visitor.number({"dead_band", "m", "of the handle from the way, in the scene, within which nothing is felt"},
                 effect.dead_band, above_to(0, 1));
  visitor.optional_number(
      {"window", "m", "in the scene, how much of the way ahead is looked at; without it ten dead bands"},
      effect.window, above_to(0, 10));
  visitor.optional_number({"stiffness", "N/m", "at the device; without it, what suits the device"},
                          effect.stiffness, above_to(0, 1e5));
  visitor.optional_number({"max_force", "N", "at the device; without it a fifth of its largest"},
                          effect.max_force, above_to(0, 1000));
  visitor.number({"ahead", "s", "by which the expert's tool that is shown is ahead"}, effect.ahead,
                 from_to(0, 60));
  visitor.number({"gain", "", "of pull and ghost; 0: off at the start, and no trial with more is scored"},
                 effect.gain, kFraction);
}

}  // namespace

std::initializer_list<std::string_view> impact_material_key() {
  static const std::initializer_list<std::string_view> kKey{"impact_vibration", "material"};
  return kKey;
}

void describe_effects_of_device(KeyVisitor& visitor, Scenario& scenario) {
  visitor.mapping(
      {"workspace_walls", "",
       "the end of the device's workspace is felt as soft walls, before its arm's stops"},
      [&](KeyVisitor& inner) {
        describe_workspace_walls(inner, scenario.effects.workspace_walls.emplace());
      });
}

void describe_material_file(KeyVisitor& visitor, ImpactMaterial& material) {
  visitor.version({"fulcrum", "", "version of the file's format", true}, kFormatVersion);
  visitor.text({"name", "", "as lists show it", true}, material.name);
  visitor.number({"attack", "kg/s", "A: amplitude, in N for each m/s of approach", true}, material.attack,
                 from_to(0, 1000));
  visitor.number({"decay", "1/s", "B: of the amplitude", true}, material.decay, from_to(0.5, 1000));
  visitor.number({"frequency_Hz", "", "f: of an impact beside the hand", true}, material.frequency_Hz,
                 from_to(12, 1000));
}

void describe_effects(KeyVisitor& visitor, Scenario& scenario) {
  visitor.mapping(
      {"torque_substitution", "", "tells of torque that the device cannot push back"},
      [&](KeyVisitor& inner) {
        describe_torque_substitution(inner, scenario.effects.torque_substitution.emplace());
      });
  visitor.mapping(
      {"impact", "", "what counts as an impact, for the effects that begin at one"},
      [&](KeyVisitor& inner) { describe_impact(inner, scenario.impact); });
  visitor.mapping(
      {"impact_vibration", "", "a vibration that tells where an impact fell"},
      [&](KeyVisitor& inner) { describe_impact_vibration(inner, scenario); });
  visitor.mapping(
      {"braking_pulse", "", "stops the hand at an impact, so that what it strikes feels harder"},
      [&](KeyVisitor& inner) { describe_braking_pulse(inner, scenario.effects.braking_pulse.emplace()); });
  visitor.mapping(
      {"vibrotactile_motion", "",
       "resistance told by two vibrators at the finger: a phantom that moves against the sweep"},
      [&](KeyVisitor& inner) {
        describe_vibrotactile_motion(inner, scenario.effects.vibrotactile_motion.emplace());
      });
  visitor.mapping(
      {"holding_point", "", "where the hand holds the tool, along a stick: told, or measured by its strip"},
      [&](KeyVisitor& inner) { describe_holding_point(inner, scenario.holding_point.emplace()); });
  visitor.mapping(
      {"inertia_compensation", "", "makes up for the device's own mass"},
      [&](KeyVisitor& inner) {
        describe_inertia_compensation(inner, scenario.effects.inertia_compensation.emplace());
      });
  visitor.mapping(
      {"texture", "", "ridges that are felt while sliding, on surfaces that are smooth"},
      [&](KeyVisitor& inner) { describe_texture(inner, scenario.effects.texture.emplace()); });
  visitor.mapping(
      {"guidance", "", "on request: a pull towards the expert's way, and the expert's tool a little ahead"},
      [&](KeyVisitor& inner) { describe_guidance(inner, scenario.effects.guidance.emplace()); });
}

void check_expert(KeyVisitor& visitor, const Scenario& scenario) {
  const bool has_expert = std::ranges::count(scenario.hands, kExpertHand, &HandEntry::name) > 0;
  visitor.rule("guidance", has_expert || !follows_expert(scenario.effects),
               "leads along the way of a hand 'expert', which 'hands' does not name: name one, or leave "
               "guidance out");
}

}  // namespace fulcrum::scenario
