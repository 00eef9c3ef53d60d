#include "haptics/effects/guidance/guidance_effect.h"

#include <algorithm>
#include <cmath>

#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"

namespace fulcrum {
namespace {

constexpr double kLongestWay = 1e6;  // s, far beyond any trial

}  // namespace

void GuidanceEffect::check(FigureCheck& figures, const Desc& guidance) {
  const auto& [way, dead_band, window, stiffness, max_force, ahead, gain] = guidance;
  for (const GuidancePose& pose : way) {
    figures.from_to("guidance.way.time", pose.time, 0, kLongestWay);
    figures.pose("guidance.way", pose.X_WT);
  }
  figures.above_to("guidance.dead_band", dead_band, 0, 1);
  if (window) figures.above_to("guidance.window", *window, 0, 10);
  if (stiffness) figures.above("guidance.stiffness", *stiffness);
  if (max_force) figures.above("guidance.max_force", *max_force);
  figures.from_to("guidance.ahead", ahead, 0, 60);
  figures.from_to("guidance.gain", gain, 0, 1);
}

std::optional<Error> GuidanceEffect::refuse(const Desc& guidance, const PlainScene& scene) {
  if (guidance.way.empty())
    return Error{
        "guidance has no way to lead along: name a hand 'expert' among 'hands', or leave guidance out."};
  const auto later = [](const GuidancePose& a, const GuidancePose& b) { return a.time > b.time; };
  if (std::adjacent_find(guidance.way.begin(), guidance.way.end(), later) != guidance.way.end())
    return Error{"guidance.way goes back in time: give its poses in the order in which they come."};
  const DeviceDesc& device = scene.device;
  if (!device.renders_force) return std::nullopt;
  const double most = Guidance::kMostForceShare * device.max_force;
  if (guidance.max_force && *guidance.max_force > most)
    return Error{"guidance.max_force is " + number_text(*guidance.max_force) + " N, and it may have " +
                 number_text(most) + " N, half of what the device '" + device.name +
                 "' can push with: lower it, or leave it out and it is chosen."};
  const double limit = DampedSpring::kMostShare * DampedSpring::limit(device, scene.tick_s);
  if (!guidance.stiffness || *guidance.stiffness <= limit) return std::nullopt;
  return Error{"guidance.stiffness is " + number_text(*guidance.stiffness) +
               " N/m, and beside a coupling the device '" + device.name + "' holds at most " +
               number_text(limit) + " N/m at a tick of " + number_text(scene.tick_s * 1e3) +
               " ms: lower it, or leave it out and it is chosen."};
}

std::vector<LeftOut> GuidanceEffect::left_out(const Desc& /*desc*/, const PlainScene& scene) {
  if (scene.device.renders_force) return {};
  return {{"pull", "the device '" + scene.device.name + "' has no motors"}};
}

std::vector<Knob> GuidanceEffect::knobs(const Desc& desc, const PlainScene& scene,
                                        const EffectRecords& records) {
  const GuidanceRecord record = records.guidance.value_or(GuidanceRecord());
  const double largest = desc.max_force.value_or(Guidance::kForceShare * scene.device.max_force);
  const bool pulls = scene.device.renders_force && largest > 0;
  return {{.kind = Command::Kind::guidance_gain,
           .name = pulls ? "Pull" : "Expert",
           .key = 'L',
           .gain = record.gain,
           .on = desc.gain > 0 ? desc.gain : 1,
           .level = pulls ? std::min(1.0, record.force_D.norm() / largest) : record.level}};
}

std::vector<GuidancePose> GuidanceEffect::way_of(const std::vector<Waypoint>& waypoints) {
  std::vector<GuidancePose> way;
  double time = 0;
  for (const Waypoint& waypoint : waypoints) {
    if (!way.empty()) time += waypoint.travel;
    way.push_back({time, waypoint.X_WT, waypoint.dwell > 0});
  }
  return way;
}

GuidanceEffect::GuidanceEffect(const Desc& desc, const PlainScene& scene)
    : effect_(desc, {.p_TH = scene.tool.X_HT.inverse().p,
                     .mapping = scene.mapping,
                     .device = scene.device,
                     .tick_s = scene.tick_s}) {
  if (effect_.spring() != nullptr) limit_ = DampedSpring::limit(scene.device, scene.tick_s);
}

Wrench GuidanceEffect::shape(const EffectTick& tick) noexcept {
  return {effect_.process({.p_WH = tick.handle.X_WH.p,
                           .per_tick_D = tick.handle.per_tick_D.head<3>(),
                           .engaged = tick.handle.engaged}),
          Vec3::Zero()};
}

Settled GuidanceEffect::settle(const EffectTick& /*tick*/, const Rendered& /*rendered*/) noexcept {
  return {.correction_F_H_D = {}, .stored = effect_.stored()};
}

void GuidanceEffect::record(EffectRecords& records) const noexcept {
  records.guidance = effect_.record();
}

BuiltPart GuidanceEffect::part() const {
  const GuidanceDesc& guidance = effect_.desc();
  std::string what = "the expert's way, " + number_text(effect_.way().length()) + " m in " +
                     std::to_string(effect_.way().pieces()) + " pieces; dead band " +
                     number_text(guidance.dead_band * 1e3) + " mm, window " +
                     number_text(effect_.window() * 1e3) + " mm";
  if (const DampedSpring* spring = effect_.spring())
    what += "; " + number_text(spring->stiffness()) + " N/m and " + number_text(spring->damping()) +
            " N s/m, up to " + number_text(spring->max_force()) + " N; let go, the device holds up to " +
            number_text(limit_) + " N/m";
  return {kName, what, sizeof(Guidance)};
}

}  // namespace fulcrum
