#pragma once
// One braking pulse at one surface: what each method makes of it with a device's motors, and what the hand
// that holds the handle feels.
//
// "Hybrid Force-Moment Braking Pulse", Eqs. 1 and 5: the force f_des = m v / (N T) along the surface's normal
// would stop the hand's momentum; a hand at G, r = p_HG from where the pulse acts, feels the force -f and the
// moment m_r = r x f - m.

#include <array>

#include "haptics/actuation/allocator.h"

namespace fulcrum::analysis::hardness {

// How it is struck.
struct StrikeSetting {
  double hand_mass = 0.45;  // kg, 0.6 % of 75 kg (Winter 1990, as the paper has it)
  double speed = 0.15;      // m/s, towards the surface
  int ticks = 1;            // N
  double tick_s = 1e-3;     // s
  double lever = 0.12;      // m, |r|
  double stiffness = 5678;  // N/m, of the surface
  double wanted_force() const { return hand_mass * speed / (ticks * tick_s); }  // N
};

// The surface's normal, along which the pulse pushes the handle, and the grasp.
struct Strike {
  Vec3 nhat_D = Vec3::UnitY();      // (3) unit
  double phi = 0;                   // rad, from the normal to the line from H to the grasp
  double lean = 0;                  // rad, to which side: 0 towards the person, right-handed about the normal
  Vec3 p_HG_D(double lever) const;  // (3) m
};

enum class PulseMethod {
  none,              // the surface's spring alone
  force_only,        // pseudoinverse, scaled
  force_only_spare,  // the same with the motors that a force has to spare
  algorithm1,        // the paper's, corrected
  exact,             // share_program.h
  nearest_wrench,    // to be shown, not used: whatever felt wrench is nearest
  free_moment        // to be shown, not used: a force in its direction, and whatever moment is nearest
};
// What a device can be told to do; the others are for a section of the page.
inline constexpr std::array kUsableMethods{PulseMethod::none, PulseMethod::force_only,
                                           PulseMethod::force_only_spare, PulseMethod::algorithm1,
                                           PulseMethod::exact};

const char* name_of(PulseMethod method);   // force_only, as in hardness.csv
const char* title_of(PulseMethod method);  // as people read it

// What came of a strike.
struct PulseOutcome {
  Wrench F_H_D;                  // of the motors
  Vec3 moment_D = Vec3::Zero();  // (3) N m, m_r at the grasp
  double force = 0;              // N, along the normal
  double tilt = 0;               // rad, of the force from the normal
  double gamma = 0;              // of the wanted force
  double mu = 0;                 // of the moment r x f_des, along it; gamma where there is none
  double missing = 0;            // N, of both, the moment in units of its lever
  // Of what the force leaves missing of the moment, the part that a moment makes up for; below 0: less moment
  // than the force alone would give.
  double delta() const { return gamma < 1 ? (mu - gamma) / (1 - gamma) : 0.0; }
  // N: the contact force that would feel as strong, with the moment counted in units of the lever. A contact
  // of force F gives the felt wrench (F, F sin(phi)), of size F sqrt(1 + sin^2(phi)).
  double contact_force(double phi, double lever) const;
};

class Striker {
public:
  // moment_weight: of `exact`.
  Striker(const DeviceDesc& device, const StrikeSetting& setting, double moment_weight = 1);

  // By what the motors can do; where each axis has its motor, the device's limits are the motors'.
  PulseOutcome strike(PulseMethod method, const Pose& X_DH, const Strike& strike);
  // Of a usable method, as the tick allocates it: within the device's largest force and torque as a whole
  // too.
  PulseOutcome in_the_tick(PulseMethod method, const Pose& X_DH, const Strike& strike);
  // Algorithm 1 with the sign of its line 9 as it is printed.
  PulseOutcome as_printed(const Pose& X_DH, const Strike& strike);

  const StrikeSetting& setting() const { return setting_; }

private:
  struct Methods {
    Methods(const DeviceDesc& device, double moment_weight);
    Allocator exact, algorithm1, pseudoinverse;
  };
  PulseOutcome strike(Methods& methods, PulseMethod method, const Pose& X_DH, const Strike& strike) const;
  PulseOutcome felt(const Wrench& F_H_D, const Strike& strike) const;

  StrikeSetting setting_;
  Methods motors_, device_;  // by the motors' limits alone; by the device's as well
};

}  // namespace fulcrum::analysis::hardness
