#pragma once
// At each impact of the held tool a decaying vibration of the handle, open loop, beside the ordinary wrench.
// Its axis and its frequency say where the impact fell, seen from the hand. J. Sreng, A. Lecuyer, C. Andriot,
// B. Arnaldi, "Spatialized haptic rendering", IEEE Virtual Reality 2009, Eqs. 3 to 7:
//     f_i    = A v n                                  A the material's, v the approach speed, n towards the
//     tool p      = r e_r                                  from the handle H, as the tool holds it, to the
//     impact wrench   W(t)   = g(r, t) (f_i; p x f_i) torque   tau(t) = r A g(r, t) e_r x v n
// g: distance_model.h. The axis stays what it was at the impact. Where e_r is within 5 degrees of n the
// moment vanishes and has no axis worth telling: there the force f_i g is used alone, by either model. The
// vibration begins with g(0) = 0 in the tick of the impact, so that it is there from the next tick on.
//
// The paper gives amplitudes as angles of the hand, 0.005 to 0.02 rad about a lever of 0.12 m (0.6 to 2.4
// mm). The torque behind them depends on the hand: at `hand_stiffness`, 1 N m/rad by default, what the
// simulated hand has, they are 5 to 20 mN m, and 0.042 to 0.167 N at that lever. 0.02 rad is the most that is
// rendered, all of the voice scaled alike, and never more than half of what the budget of transients lets
// through; steel reaches it from 0.2 m/s on at 0.12 m. There is no least: a soft touch is a soft vibration.
//
// A mode above what device and tick can render is left out.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "haptics/contact/impact.h"
#include "haptics/device/mapping.h"
#include "haptics/effects/impact_vibration/distance_model.h"
#include "haptics/effects/impact_vibration/impact_vibration_record.h"
#include "haptics/effects/impact_vibration/impact_voices.h"
#include "haptics/math/names_of.h"
#include "haptics/math/pose.h"
#include "haptics/scene/impact_material.h"
#include "haptics/signal/ramp.h"
#include "haptics/tick/command.h"

namespace fulcrum {

// The sine of 5 degrees: a blow whose line passes the hand at less of their distance turns nothing.
inline constexpr double kParallel = 0.087155742747658174;

enum class ImpactRender { wrench, torque };
template <>
inline constexpr std::array<std::string_view, 2> names_of<ImpactRender>{"wrench", "torque"};

struct ImpactVibrationDesc {
  ImpactRender render = ImpactRender::wrench;
  DistanceModel distance = DistanceModel::sinusoid;
  double gain = 1;            // of the amplitude; 0: named but off
  std::size_t voices = 8;     // 1 to ImpactVoices::kMax
  double hand_stiffness = 1;  // N m/rad, of the hand that is to turn by the published angles
  std::vector<ImpactMaterial> materials{ImpactMaterial()};  // of each object of the scene, by its number
};

inline void mirror(ImpactVibrationDesc&) {}  // it has no sides

// What the effect needs to know of the scene around it.
struct ImpactSurroundings {
  double tick_s;
  double reach;           // m, of the tool from the handle
  MappingDesc mapping;    // of the device
  double largest_force;   // N, of the device, that a transient may have; 0: it does not push
  double largest_torque;  // N m, of the device, that a transient may have; 0: it renders none
  double highest_Hz;      // that device and tick can render
};

class ImpactVibration {
public:
  static constexpr double kSwell = 20e-3;  // s, in which it fades when switched

  ImpactVibration(const ImpactVibrationDesc& desc, const ImpactSurroundings& around);

  // One tick. impacts: of this tick. p_WH (3) m: the handle's place on the tool. engaged: the hand holds the
  // tool and feels it. Answers the wrench on the handle in this tick, a transient, in D.
  Wrench process(std::span<const Impact> impacts, const Vec3& p_WH, bool engaged = true) noexcept;

  void apply(const Command& command) noexcept;

  const ImpactVibrationRecord& record() const {
    return record_;
  }  // all but what was commanded, and its energy
  const ImpactSurroundings& around() const { return around_; }

private:
  void start(const Impact& impact, const Vec3& p_WH) noexcept;
  Wrench capped(const Wrench& amplitude_D, const VibrationModes& modes) const noexcept;

  ImpactVibrationDesc desc_;
  ImpactSurroundings around_;
  ImpactVoices voices_;
  Ramp gain_;
  ImpactVibrationRecord record_;
};

// Hz that device and tick can render: no higher than the device's bandwidth, and with 2.5 samples a period;
// with fewer the held samples are mostly mirror tones.
double highest_vibration(double bandwidth_Hz, double tick_s) noexcept;

}  // namespace fulcrum
