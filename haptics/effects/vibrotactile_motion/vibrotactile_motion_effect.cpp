#include "haptics/effects/vibrotactile_motion/vibrotactile_motion_effect.h"

#include <algorithm>

#include "haptics/actuation/vibrotactile_output.h"
#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"
#include "haptics/scene/coupling_gains.h"
#include "haptics/signal/held_sine.h"

namespace fulcrum {
namespace {

// The device's channels, and what they can do at the carrier.
std::string channels_text(const VibrotactileMotionDesc& desc, const VibrotactileDesc& vibrotactile) {
  std::string what =
      "; " + number_text(desc.strength) + " m/s^2 at " + number_text(desc.carrier_Hz) + " Hz on";
  for (const ChannelDesc& channel : vibrotactile.channels) {
    what += (&channel == vibrotactile.channels.data() ? " " : ", ") + channel.name;
    const bool pcm = channel.kind == ChannelKind::pcm;
    if (pcm)
      what += " (" + number_text(channel.rate_Hz * 1e-3) + " kHz, ";
    else
      what += channel.kind == ChannelKind::tone ? " (tone: a frequency and an amplitude, "
                                                : " (rumble: an amplitude alone, ";
    what += "up to " + number_text(actuator_reach(channel, desc.carrier_Hz)) + " m/s^2";
    const double rise = 1 / (ChannelOutput::kStep * channel.rate_Hz);  // s, of pcm
    if (!pcm)
      what += ", " + number_text(channel.lag * 1e3) + " ms behind";
    else if (rise > 1 / desc.update_Hz)
      what += " after " + number_text(rise * 1e3) + " ms, longer than an update";
    what += ")";
  }
  return what;
}

}  // namespace

std::string VibrotactileMotionEffect::why_not(const Desc& desc, const PlainScene& scene) {
  const DeviceDesc& device = scene.device;
  const bool channels = device.vibrotactile.has_value();
  const bool fallback = desc.use == VibrotactileUse::fallback;
  const bool pushes = fallback ? device.renders_force || device.renders_torque
                               : device.renders_force && desc.lateral_force > 0;
  if (fallback ? channels && !pushes : channels || pushes) return "";
  if (!channels) return "the device '" + device.name + "' has no channels";
  return "it is a fallback, and the device '" + device.name + "' has motors";
}

void VibrotactileMotionEffect::check(FigureCheck& figures, const Desc& motion) {
  const auto& [use, law, strength, update_Hz, carrier_Hz, gain, centre_W, axis_W, lateral_force, full_speed,
               full_force] = motion;
  const auto& [envelope, onset, window, reference] = law;
  const std::string name = "vibrotactile_motion";
  figures.above(name + ".window", window);
  figures.above(name + ".reference", reference);
  figures.above(name + ".strength", strength);
  figures.above_to(name + ".update_Hz", update_Hz, 0, FigureCheck::kFastest_Hz);
  figures.above_to(name + ".carrier_Hz", carrier_Hz, 0, FigureCheck::kFastest_Hz);
  figures.from_to(name + ".gain", gain, 0, 1);
  figures.finite(name + ".centre", centre_W);
  figures.direction(name + ".axis", axis_W);
  figures.at_least(name + ".lateral_force", lateral_force);
  figures.above(name + ".full_speed", full_speed);
  figures.above(name + ".full_force", full_force);
}

std::optional<Error> VibrotactileMotionEffect::refuse(const Desc& desc, const PlainScene& scene) {
  if (!scene.device.vibrotactile) return std::nullopt;
  for (const ChannelDesc& channel : scene.device.vibrotactile->channels) {
    if (channel.kind == ChannelKind::pcm && desc.carrier_Hz * kMinSamplesPerPeriod > channel.rate_Hz)
      return Error{"vibrotactile_motion.carrier_Hz is " + number_text(desc.carrier_Hz) + ", and channel '" +
                   channel.name + "' of the device '" + scene.device.name + "' renders up to " +
                   number_text(channel.rate_Hz / kMinSamplesPerPeriod) + " Hz: lower it."};
  }
  return std::nullopt;
}

std::vector<LeftOut> VibrotactileMotionEffect::left_out(const Desc& desc, const PlainScene& scene) {
  if (desc.use == VibrotactileUse::fallback) return {};
  const std::string device = "the device '" + scene.device.name + "' ";
  std::vector<LeftOut> parts;
  if (!scene.device.vibrotactile) parts.push_back({"vibration of the sweep", device + "has no channels"});
  if (desc.lateral_force == 0)
    parts.push_back({"lateral force", "vibrotactile_motion.lateral_force is 0"});
  else if (!scene.device.renders_force)
    parts.push_back({"lateral force", device + "has no motors"});
  return parts;
}

std::optional<ChannelUse> VibrotactileMotionEffect::channel_use(const Desc& desc, const PlainScene& scene) {
  if (!scene.device.vibrotactile) return std::nullopt;
  ChannelUse use{.signal = {.carrier_Hz = desc.carrier_Hz, .largest = desc.strength}};
  if (desc.use == VibrotactileUse::sweep) use.axis_W = desc.axis_W;
  return use;
}

// The lateral force is a damper of lateral_force / full_speed, without a spring.
std::optional<std::string> VibrotactileMotionEffect::advise(const Desc& desc, const PlainScene& scene) {
  if (desc.use != VibrotactileUse::sweep || desc.lateral_force == 0) return std::nullopt;
  const double damping = desc.lateral_force / desc.full_speed;
  const double limit = damping_limit(scene);
  if (damping <= limit) return std::nullopt;
  return "vibrotactile_motion.lateral_force / full_speed is " + number_text(damping) +
         " N s/m, and the device, let go, holds at most " + number_text(limit) +
         " N s/m: it may buzz in a light hand. Lower the one or raise the other, raise tick_rate_Hz, or name "
         "a velocity_estimator that is less late.";
}

std::vector<Knob> VibrotactileMotionEffect::knobs(const Desc& desc, const PlainScene& scene,
                                                  const EffectRecords& records) {
  if (!scene.device.vibrotactile) return {};
  const VibrotactileRecord record = records.vibrotactile_motion.value_or(VibrotactileRecord());
  return {{.kind = Command::Kind::vibrotactile_gain,
           .name = "Vibration",
           .key = 'T',
           .gain = record.gain,
           .on = desc.gain > 0 ? desc.gain : 1,
           .level = std::ranges::max(record.command.level) / desc.strength}};
}

VibrotactileMotionEffect::VibrotactileMotionEffect(const Desc& desc, const PlainScene& scene)
    : mapping_(scene.mapping),
      renders_force_(scene.device.renders_force),
      channels_(scene.device.vibrotactile),
      effect_(desc, channels_ ? &*channels_ : nullptr, scene.mapping.position_scale, scene.tick_s) {}

Wrench VibrotactileMotionEffect::shape(const EffectTick& tick) noexcept {
  const Twist& V_WH = tick.handle.V_WH;
  Vec6 velocity;
  velocity << V_WH.v, V_WH.w;
  const Vec3 force_W = effect_.process({.p_WH = tick.handle.X_WH.p,
                                        .v_WH = V_WH.v,
                                        .moved = tick.handle.moved_D[0],
                                        .speed = mapping_.motion_in_device(velocity)[0],
                                        .felt = tick.wished_D.x(),
                                        .touching = !tick.regions.empty(),
                                        .engaged = tick.handle.engaged,
                                        .stopped = tick.stopped});
  if (!renders_force_) return {};
  return {mapping_.X_WD.q.conjugate() * force_W, Vec3::Zero()};
}

void VibrotactileMotionEffect::command(const EffectTick& /*tick*/, double gain, bool stopped,
                                       DeviceCommand& command) noexcept {
  command.vibrotactile = effect_.render(gain, stopped);
}

void VibrotactileMotionEffect::record(EffectRecords& records) const noexcept {
  records.vibrotactile_motion = effect_.record();
}

BuiltPart VibrotactileMotionEffect::part() const {
  const VibrotactileMotionDesc& desc = effect_.desc();
  std::string what = desc.law.envelope == MotionEnvelope::linear
                         ? "linear"
                         : "logarithmic with " + number_text(desc.law.reference * 1e3) + " mm";
  what += desc.law.onset == MotionOnset::together ? ", both together" : ", one after the other";
  what += ", over " + number_text(desc.law.window * 1e3) + " mm";
  if (channels_) what += channels_text(desc, *channels_);
  if (desc.use == VibrotactileUse::fallback)
    what += "; in place of the force along the line of the channels";
  else if (desc.lateral_force > 0 && renders_force_)
    what += "; with " + number_text(desc.lateral_force) + " N";
  return {kName, what, sizeof(VibrotactileMotion)};
}

}  // namespace fulcrum
