#include "haptics/effects/impact_vibration/impact_vibration.h"

#include <algorithm>
#include <cmath>

#include "haptics/signal/held_sine.h"

namespace fulcrum {
namespace {

constexpr double kLargestAngle = 0.02;  // rad, of the hand
constexpr double kShare = 0.5;          // of a budget's peak, for one voice

}  // namespace

ImpactVibration::ImpactVibration(const ImpactVibrationDesc& desc, const ImpactSurroundings& around)
    : desc_(desc), around_(around), voices_(desc.voices, around.tick_s), gain_(kSwell, around.tick_s) {
  record_.gain = desc.gain;
}

Wrench ImpactVibration::process(std::span<const Impact> impacts, const Vec3& p_WH, bool engaged) noexcept {
  const double gain = engaged ? record_.gain : 0.0;
  Wrench F_H_D = voices_.next() * gain_.towards(gain);
  if (gain > 0)
    for (const Impact& impact : impacts) start(impact, p_WH);
  record_.voices = static_cast<std::int32_t>(voices_.sounding());
  record_.dropped = voices_.dropped();
  return F_H_D;
}

void ImpactVibration::start(const Impact& impact, const Vec3& p_WH) noexcept {
  const auto object = static_cast<std::size_t>(std::max(impact.object, 0));
  const ImpactMaterial& material = desc_.materials[std::min(object, desc_.materials.size() - 1)];
  const Vec3 p_W = impact.p_W - p_WH;
  const double r = p_W.norm();
  const Vec3 lever_W = p_W.cross(impact.nhat_W);
  const bool turns = lever_W.norm() > kParallel * r;  // not where r is 0
  const double f = material.attack * impact.speed;

  VibrationModes modes;
  for (const VibrationModes all = vibration_modes(desc_.distance, material.frequency_Hz, r, around_.reach);
       const VibrationModes::Mode& mode : std::span(all.modes).first(all.count))
    if (mode.frequency_Hz <= around_.highest_Hz) modes.modes[modes.count++] = mode;
  Wrench amplitude_W;
  if (!turns || desc_.render == ImpactRender::wrench) amplitude_W.force = f * impact.nhat_W;
  if (turns) amplitude_W.torque = f * lever_W;
  const Wrench amplitude_D = capped(around_.mapping.wrench_in_device(amplitude_W), modes);
  if (!std::isfinite(r) || !amplitude_D.is_finite() || amplitude_D.is_zero() || modes.count == 0) return;

  if (!voices_.start(amplitude_D, modes, material.decay)) return;
  record_.frequency_Hz = modes.modes[0].frequency_Hz;
  record_.radius = r;
  record_.axis_W = turns ? Vec3(lever_W.normalized()) : Vec3(Vec3::Zero());
  record_.amplitude_D = amplitude_D;
}

// What the device renders of it, no stronger than a hand is to be shaken, the modes at their strongest
// together.
Wrench ImpactVibration::capped(const Wrench& amplitude_D, const VibrationModes& modes) const noexcept {
  double sum = 0;
  for (const VibrationModes::Mode& mode : modes.modes) sum += std::abs(mode.amplitude);
  const double torque = kLargestAngle * desc_.hand_stiffness;
  Wrench F = amplitude_D;
  if (around_.largest_force == 0) F.force.setZero();
  if (around_.largest_torque == 0) F.torque.setZero();
  const double largest_force = std::min(torque / kEqualLever, kShare * around_.largest_force);
  const double largest_torque = std::min(torque, kShare * around_.largest_torque);
  double part = 1;
  if (sum * F.force.norm() > largest_force) part = largest_force / (sum * F.force.norm());
  if (part * sum * F.torque.norm() > largest_torque) part = largest_torque / (sum * F.torque.norm());
  return F * part;
}

void ImpactVibration::apply(const Command& command) noexcept {
  if (command.kind == Command::Kind::impact_gain) record_.gain = command.gain();
}

double highest_vibration(double bandwidth_Hz, double tick_s) noexcept {
  return std::min(bandwidth_Hz, 1 / (kMinSamplesPerPeriod * tick_s));
}

}  // namespace fulcrum
