#include "engine/scenario/describe.h"

namespace fulcrum::scenario {

namespace {

constexpr std::array<std::string_view, 3> kVariants{"A", "B", "C"};  // in the order of TorqueVariant
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
      effect.variant, kVariants);
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
  visitor.mapping({"vibration", "", "of the handle, while torque is bad"},
                  [&](KeyVisitor& inner) { describe_vibration(inner, effect); });
  visitor.mapping({"ghost", "", "of the tool, turned as the hand is, while torque is large"},
                  [&](KeyVisitor& inner) { describe_ghost(inner, effect); });
}

}  // namespace

void describe_effects(KeyVisitor& visitor, Scenario& scenario) {
  visitor.mapping({"torque_substitution", "", "tells of torque that the device cannot push back"},
                  [&](KeyVisitor& inner) {
                    describe_torque_substitution(inner, scenario.torque_substitution.emplace());
                  });
}

}  // namespace fulcrum::scenario
