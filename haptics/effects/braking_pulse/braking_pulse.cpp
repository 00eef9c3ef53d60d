#include "haptics/effects/braking_pulse/braking_pulse.h"

#include <algorithm>

namespace fulcrum {

BrakingPulse::BrakingPulse(const BrakingPulseDesc& desc, const MappingDesc& mapping, double tick_s)
    : desc_(desc),
      mapping_(mapping),
      force_per_speed_(desc.hand_mass / mapping.position_scale / (desc.ticks * tick_s)) {
  record_.gain = desc.gain;
  record_.moment = desc.moment;
}

void BrakingPulse::strike(const Tick& tick, const Impact& impact) noexcept {
  double speed = impact.speed;
  // Two blows against each other, of a tool that turns, leave each other what they have.
  for (const Pulse& pulse : pulses_)
    if (pulse.left > 0) speed -= pulse.speed * std::max(0.0, pulse.nhat_W.dot(impact.nhat_W));
  if (!(speed > 0)) return;
  pulses_[next_] = {tick.X_WG.inverse() * impact.p_W, impact.nhat_W, speed, desc_.ticks};
  next_ = (next_ + 1) % kMax;
}

BrakingPulse::Demand BrakingPulse::process(const Tick& tick) noexcept {
  for (Pulse& pulse : pulses_) {
    if (pulse.left == 0) continue;
    const Vec3 p_W = tick.X_WG * pulse.p_G;
    const Vec3 v_W = tick.V_WG.v + tick.V_WG.w.cross(Vec3(p_W - tick.X_WG.p));
    if (!tick.engaged || !(v_W.dot(pulse.nhat_W) < 0)) pulse.left = 0;
  }
  if (tick.engaged && record_.gain > 0)
    for (const Impact& impact : tick.impacts) strike(tick, impact);

  Demand demand;
  const Quat q_DW = mapping_.X_WD.q.conjugate();
  double strongest = 0;
  Vec3 p_HP_D = Vec3::Zero();  // of the strongest
  for (Pulse& pulse : pulses_) {
    if (pulse.left == 0) continue;
    --pulse.left;
    const Vec3 lever_D = q_DW * Vec3(tick.X_WG * pulse.p_G - tick.p_WH) / mapping_.position_scale;
    const double size = record_.gain * force_per_speed_ * pulse.speed;
    const Vec3 f_D = size * (q_DW * pulse.nhat_W);
    demand.F_H_D += {f_D, lever_D.cross(f_D)};
    if (size <= strongest) continue;
    strongest = size;
    p_HP_D = lever_D;
  }
  demand.moment = record_.moment;
  demand.p_HG_D = q_DW * (tick.q_WH * desc_.p_HG) / mapping_.position_scale;
  demand.lever = (demand.p_HG_D - p_HP_D).norm();
  record_.wanted_F_H_D = demand.F_H_D;
  return demand;
}

void BrakingPulse::apply(const Command& command) noexcept {
  if (command.kind == Command::Kind::pulse_gain) record_.gain = command.gain();
  if (command.kind == Command::Kind::pulse_moment) record_.moment = command.value > 0;
}

}  // namespace fulcrum
