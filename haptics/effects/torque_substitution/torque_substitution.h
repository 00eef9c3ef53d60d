#pragma once
// Torque that a device senses and cannot push back, told by other means: "Haptic rendering for under-actuated
// 6/3-DOF haptic devices". Each tick the torque between hand and tool is called good or bad
// (torque_classifier.h); while it is bad the coupling is softened in rotation (torque_limit.h) and the handle
// vibrates (vibration_cue.h); while it is large a ghost of the tool shows where the hand has turned to.
//
// All of it goes by the torque that the coupling's full stiffness gives: a softened one would end what
// softened it.
//
// What a device or a response has no use for is not built: nothing where the device renders torque; no
// vibration without motors; no ghost where it senses no rotation; no limit under the response constraint,
// where the tool stays out of the scene whatever the torque. On a 3/3-DOF device torque comes from pushing
// alone: the vibration is there, and moving back is what ends it.

#include <optional>

#include "haptics/effects/torque_substitution/torque_classifier.h"
#include "haptics/effects/torque_substitution/torque_limit.h"
#include "haptics/effects/torque_substitution/torque_record.h"
#include "haptics/effects/torque_substitution/vibration_cue.h"
#include "haptics/math/names_of.h"
#include "haptics/math/pose.h"
#include "haptics/tick/command.h"

namespace fulcrum {

// The variants of the paper's study: which cues are on at the start.
enum class TorqueVariant { A, B, C };  // none; vibration; vibration and ghost
template <>
inline constexpr std::array<std::string_view, 3> names_of<TorqueVariant>{"A", "B", "C"};

// What is left out follows from the tool, the coupling and the device.
struct TorqueSubstitutionDesc {
  TorqueVariant variant = TorqueVariant::C;
  std::optional<double> bad_above;    // N m, T_min; a tenth of the coupling's largest torque
  std::optional<double> tool_radius;  // m, R_d; the farthest that the tool reaches from its centre of mass
  bool limit_stiffness = true;

  double vibration_gain = 1;  // of the amplitude, while it is on
  double amplitude = 0.4;     // N at the handle, at the coupling's largest torque
  double frequency_Hz = 200;
  std::optional<double> reference;  // N m, tau_0; bad_above

  double ghost_gain = 1;              // of the opacity, while it is on
  std::optional<double> ghost_above;  // N m, T_on; twice bad_above
  std::optional<double> ghost_below;  // N m, T_off; 0.6 of ghost_above
  double ghost_fade = 0.15;           // s
};

inline void mirror(TorqueSubstitutionDesc&) {}  // it has no sides

// N m: what a Desc says, and where it says nothing what follows from the coupling's largest torque.
struct TorqueThresholds {
  double bad, ghost_above, ghost_below;  // T_min, T_on, T_off
};
inline TorqueThresholds torque_thresholds(const TorqueSubstitutionDesc& desc, double coupling_torque) {
  const double bad = desc.bad_above.value_or(0.1 * coupling_torque);
  const double above = desc.ghost_above.value_or(2 * bad);
  return {bad, above, desc.ghost_below.value_or(0.6 * above)};
}

// What the effect needs to know of the scene around it.
struct TorqueSurroundings {
  double tick_s;
  double tool_reach;   // m, the farthest point of the tool from T
  double max_force;    // N, of the coupling
  double max_torque;   // N m, of the coupling
  bool renders_force;  // the device has motors
  bool senses_rotation;
  bool springs;  // contact gives way, so that a torque can press the tool in
};

class TorqueSubstitution {
public:
  TorqueSubstitution(const TorqueSubstitutionDesc& desc, const TorqueSurroundings& around);

  struct Tick {
    Vec3 contact_torque = Vec3::Zero();      // (3) N m, of the scene on the tool, about T
    Wrench coupling_F_T_W;                   // of the coupling's full stiffness, less what carries the weight
    double torque = 0;                       // N m, what the coupling gave
    double angle = 0;                        // rad, by which its spring is wound
    std::span<const ContactRegion> regions;  // that touch
    Vec3 felt_D = Vec3::Zero();              // (3) N, the continuous force on the handle
    bool engaged = true;                     // the hand holds the tool; false while clutched
  };
  struct Demand {
    Vec3 vibration_D = Vec3::Zero();           // (3) N on the handle, a transient
    double torque_limit = TorqueLimit::kNone;  // N m, of the coupling, from the next tick on
  };
  Demand process(const Tick& tick) noexcept;

  void apply(const Command& command) noexcept;

  const TorqueRecord& record() const { return record_; }  // all but the energy
  bool vibrates() const { return vibration_.has_value(); }
  bool shows_ghost() const { return shows_ghost_; }
  bool limits() const { return limit_.has_value(); }
  const TorqueBounds& bounds() const { return bounds_; }
  double ghost_above() const { return ghost_above_; }
  double ghost_below() const { return ghost_below_; }

private:
  TorqueBounds bounds_;
  TorqueClassifier classifier_;
  std::optional<TorqueLimit> limit_;
  std::optional<VibrationCue> vibration_;
  bool shows_ghost_;
  double ghost_above_, ghost_below_;  // N m
  Ramp ghost_;
  bool ghost_wanted_ = false;
  TorqueRecord record_;
};

}  // namespace fulcrum
