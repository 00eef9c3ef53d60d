#pragma once
// At an impact, a wrench on the handle that would stop the hand within `ticks` ticks, so that a surface feels
// harder than its stiffness is: "Hybrid Force-Moment Braking Pulse", Eq. 1,
//     f_des = -(1/(N T)) n n^T m v        m of the hand: 0.6 % of the body's mass, or as set
// for each place that is struck while the hand approaches it. Of places that are struck in one tick, and of
// pulses that have not ended, each takes away what the others leave of the speed along its normal: together
// they ask for no more impulse than the hand has. A pulse ends when the hand no longer approaches; one of a
// single tick is over by then.
//
// Motors give a small part of it. While the moment is on they may give, beside the force, a moment that makes
// up for the rest of it at the grasp G: the hand feels m_r = p_PG x f - m, and Eqs. 6 and 11 and line 9 of
// Algorithm 1 have the opposite sign of what their own Eq. 5 asks for (actuation/allocator.h).

#include <array>
#include <span>

#include "haptics/contact/impact.h"
#include "haptics/device/mapping.h"
#include "haptics/effects/braking_pulse/pulse_record.h"
#include "haptics/math/mirror.h"
#include "haptics/math/pose.h"
#include "haptics/tick/command.h"

namespace fulcrum {

struct BrakingPulseDesc {
  double hand_mass = 0.45;   // kg, of hand and handle: 0.6 % of 75 kg
  int ticks = 1;             // that the pulse lasts, 1 to 50; the paper's N
  Vec3 p_HG = Vec3::Zero();  // (3) m, where the hand holds the handle, in the scene's metres
  bool moment = true;        // at the start
  double gain = 1;           // of the force; 0: named but off
};

inline void mirror(BrakingPulseDesc& desc) {
  mirror(desc.p_HG);
}

class BrakingPulse {
public:
  static constexpr int kMaxTicks = 50;
  static constexpr double kHandOfBody = 0.006;  // D. A. Winter, as the paper cites him

  // mapping: of the device, whose hand is slower than the scene's by position_scale.
  BrakingPulse(const BrakingPulseDesc& desc, const MappingDesc& mapping, double tick_s);

  struct Tick {
    std::span<const Impact> impacts;
    Vec3 p_WH = Vec3::Zero();  // (3) m, the handle's place on the tool
    Quat q_WH = Quat::Identity();
    Pose X_WG;            // where the hand wants the tool
    Twist V_WG;           // how fast
    bool engaged = true;  // the hand holds the tool and feels it; false while clutched or stopped
  };
  struct Demand {
    Wrench F_H_D;                // that would stop the hand, about H
    Vec3 p_HG_D = Vec3::Zero();  // (3) m, as the device is large
    double lever = 0;            // m, from where it strikes to the grasp
    bool moment = false;         // may make up for force
  };
  Demand process(const Tick& tick) noexcept;

  void apply(const Command& command) noexcept;

  const PulseRecord& record() const { return record_; }  // all but what was commanded, and its energy
  const BrakingPulseDesc& desc() const { return desc_; }

private:
  static constexpr std::size_t kMax = 16;  // pulses at a time; one more takes the place of the oldest
  struct Pulse {
    Vec3 p_G = Vec3::Zero();     // (3) m, where it strikes, in the frame that the hand wants for the tool
    Vec3 nhat_W = Vec3::Zero();  // (3) unit
    double speed = 0;            // m/s in the scene, that it takes away
    int left = 0;                // ticks
  };
  void strike(const Tick& tick, const Impact& impact) noexcept;

  BrakingPulseDesc desc_;
  MappingDesc mapping_;
  double force_per_speed_;  // N for each m/s in the scene
  std::array<Pulse, kMax> pulses_{};
  std::size_t next_ = 0;
  PulseRecord record_;
};

}  // namespace fulcrum
