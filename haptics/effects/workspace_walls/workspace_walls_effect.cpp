#include "haptics/effects/workspace_walls/workspace_walls_effect.h"

#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"

namespace fulcrum {

std::string WorkspaceWallsEffect::why_not(const Desc& /*desc*/, const PlainScene& scene) {
  return scene.device.renders_force ? "" : "the device '" + scene.device.name + "' has no motors";
}

void WorkspaceWallsEffect::check(FigureCheck& figures, const Desc& walls) {
  const auto& [margin, stiffness] = walls;
  if (margin) figures.above_to("device.workspace_walls.margin", *margin, 0, 1);
  if (stiffness) figures.above("device.workspace_walls.stiffness", *stiffness);
}

std::optional<Error> WorkspaceWallsEffect::refuse(const Desc& walls, const PlainScene& scene) {
  const DeviceDesc& device = scene.device;
  if (!device.renders_force) return std::nullopt;
  const double reach = device.workspace.minCoeff();
  if (!(reach > 0))
    return Error{"device.workspace_walls stand at the end of a workspace, and that of the device '" +
                 device.name +
                 "' has no size: give 'workspace' in its file, or leave device.workspace_walls out."};
  const double margin = WorkspaceWalls::margin(walls, device);
  if (margin >= reach)
    return Error{"device.workspace_walls.margin is " + number_text(margin * 1e3) +
                 " mm, and the workspace of the device '" + device.name + "' reaches " +
                 number_text(reach * 1e3) + " mm from its middle: make it smaller."};
  const double limit = DampedSpring::kMostShare * DampedSpring::limit(device, scene.tick_s);
  if (!walls.stiffness || *walls.stiffness <= limit) return std::nullopt;
  return Error{"device.workspace_walls.stiffness is " + number_text(*walls.stiffness) +
               " N/m, and beside a coupling the device '" + device.name + "' holds at most " +
               number_text(limit) + " N/m at a tick of " + number_text(scene.tick_s * 1e3) +
               " ms: lower it, or leave it out and it is chosen."};
}

WorkspaceWallsEffect::WorkspaceWallsEffect(const Desc& desc, const PlainScene& scene)
    : effect_(desc, scene.device, scene.tick_s),
      margin_(WorkspaceWalls::margin(desc, scene.device)),
      limit_(DampedSpring::limit(scene.device, scene.tick_s)) {}

Wrench WorkspaceWallsEffect::shape(const EffectTick& tick) noexcept {
  return {effect_.process(tick.handle.X_DH.p, tick.handle.per_tick_D.head<3>()), Vec3::Zero()};
}

Settled WorkspaceWallsEffect::settle(const EffectTick& /*tick*/, const Rendered& /*rendered*/) noexcept {
  return {.correction_F_H_D = {}, .stored = effect_.stored()};
}

void WorkspaceWallsEffect::record(EffectRecords& records) const noexcept {
  records.workspace_walls = effect_.record();
}

BuiltPart WorkspaceWallsEffect::part() const {
  return {kName,
          "from " + number_text(margin_ * 1e3) + " mm before its end, " + number_text(effect_.stiffness()) +
              " N/m and " + number_text(effect_.damping()) + " N s/m, up to " +
              number_text(effect_.max_force()) + " N; let go, the device holds up to " + number_text(limit_) +
              " N/m",
          sizeof(WorkspaceWalls)};
}

}  // namespace fulcrum
