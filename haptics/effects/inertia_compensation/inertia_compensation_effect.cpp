#include "haptics/effects/inertia_compensation/inertia_compensation_effect.h"

#include <algorithm>
#include <cmath>

#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

InertiaCompensationDesc with_noise(InertiaCompensationDesc desc, const DeviceDesc& device) {
  constexpr double exact = 1e-9;  // m rms, of a device whose position has no steps
  desc.filter.noise = std::max(exact, desc.encoder_noise.value_or(device.encoder_step / std::sqrt(12.0)));
  return desc;
}

InertiaCompensation::Figures figures(const PlainScene& scene) {
  constexpr double share = 0.5;  // of the device's force: the other half is the scene's
  const DeviceDesc& device = scene.device;
  return {.tick_s = scene.tick_s,
          .mass = device.handle_mass,
          .damping = device.damping,
          .encoder_step = device.encoder_step,
          .largest_force = share * device.max_force};
}

}  // namespace

std::string InertiaCompensationEffect::why_not(const Desc& /*desc*/, const PlainScene& scene) {
  return scene.device.renders_force ? "" : "the device '" + scene.device.name + "' does not push";
}

void InertiaCompensationEffect::check(FigureCheck& figures, const Desc& inertia) {
  const auto& [method, switchable, gain, budget, filter, encoder_noise] = inertia;
  const auto& [kind, jerk, noise, jerk_time, adapt_time, range] = filter;
  const std::string name = "inertia_compensation";
  figures.from_to(name + ".gain", gain, 0, 1);
  figures.above(name + ".budget", budget);
  figures.above(name + ".filter.jerk", jerk);
  figures.above(name + ".filter.noise", noise);
  figures.above_to(name + ".filter.jerk_time", jerk_time, 0, FigureCheck::kLongestTime);
  figures.above_to(name + ".filter.adapt_time", adapt_time, 0, FigureCheck::kLongestTime);
  figures.at_least(name + ".filter.range", range, 1);
  if (encoder_noise) figures.above(name + ".encoder_noise", *encoder_noise);
}

std::optional<Error> InertiaCompensationEffect::refuse(const Desc& desc, const PlainScene& scene) {
  if (desc.method == InertiaMethod::arm && !scene.holding_point)
    return Error{
        "inertia_compensation by the method arm needs to know where the hand holds: name holding_point."};
  return std::nullopt;
}

std::vector<LeftOut> InertiaCompensationEffect::left_out(const Desc& desc, const PlainScene& scene) {
  std::vector<LeftOut> parts;
  if (!scene.device.renders_torque)
    parts.push_back(
        {"inertia compensation by arm", "the device '" + scene.device.name + "' renders no torque"});
  if (!InertiaCompensation::filters(desc))
    parts.push_back({"acceleration filter", "the scenario's method needs none and is not switchable"});
  return parts;
}

InertiaCompensationEffect::InertiaCompensationEffect(const Desc& desc, const PlainScene& scene)
    : effect_(with_noise(desc, scene.device), figures(scene)),
      renders_torque_(scene.device.renders_torque),
      axis_H_(scene.holding_point ? scene.holding_point->axis_H : Vec3(Vec3::Zero())) {}

Wrench InertiaCompensationEffect::correct(const EffectTick& tick) noexcept {
  InertiaCompensation::Tick inertia{.p_DH = tick.handle.X_DH.p,
                                    .force_D = tick.wanted_F_H_D.force,
                                    .p_HG_D = tick.handle.p_HG_D,
                                    .between = false,
                                    .open = tick.gain >= 1 && !tick.stopped && tick.handle.engaged};
  if (tick.touched.any && renders_torque_) {
    const double place = tick.handle.place;
    const double along = tick.touched.p_HC.dot(axis_H_);
    inertia.between = along >= std::min(0.0, place) && along <= std::max(0.0, place);
  }
  return effect_.process(inertia);
}

Settled InertiaCompensationEffect::settle(const EffectTick& tick, const Rendered& rendered) noexcept {
  effect_.book({rendered.force_part, rendered.torque_part}, tick.handle.moved_D, tick.handle.within_tick_D,
               tick.handle.sample_age);
  const InertiaRecord& record = effect_.record();
  return {.correction_F_H_D = {record.force_D, record.torque_D},
          .torque_limit = std::nullopt,
          .faults = record.faded ? kCompensationFaded : 0u};
}

void InertiaCompensationEffect::record(EffectRecords& records) const noexcept {
  records.inertia_compensation = effect_.record();
}

BuiltPart InertiaCompensationEffect::part() const {
  std::string what(name_of(effect_.desc().method));
  if (effect_.desc().switchable) what += ", and can be switched";
  what += "; " + number_text(effect_.figures().mass * 1e3) + " g";
  if (const AccelerationEstimator* filter = effect_.filter())
    what += ", acceleration " + number_text(filter->lag() * 1e3) + " ms late, " +
            number_text(filter->noise()) + " m/s^2 of noise, up to " +
            number_text(effect_.figures().largest_force) + " N and " +
            number_text(effect_.desc().budget * 1e3) + " mJ";
  return {kName, what, sizeof(InertiaCompensation)};
}

}  // namespace fulcrum
