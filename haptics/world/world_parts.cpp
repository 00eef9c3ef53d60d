// What a World says it is made of.

#include <cmath>

#include "haptics/math/number_text.h"
#include "haptics/scene/coupling_gains.h"
#include "haptics/world/world.h"

namespace fulcrum {
namespace {

// Of the stiffness that the device renders.
std::string free_handle_limit_text(const SceneDesc& desc) {
  const double limit = coupling_limits(desc).stiffness;
  if (!std::isfinite(limit)) return "";
  return "; let go, it holds up to " +
         number_text(limit * desc.mapping.position_scale * desc.mapping.force_scale) + " N/m";
}

std::string reason_of(VoxelReason reason) {
  switch (reason) {
    case VoxelReason::given:
      return "as given";
    case VoxelReason::error:
      return "for the wanted error";
    case VoxelReason::thinnest_wall:
      return "for three across the thinnest wall";
    case VoxelReason::band:
      return "for two in the given band";
    case VoxelReason::memory:
      return "for want of memory, coarser than the wanted error asks";
  }
  return "";
}

BuiltPart field_part(const char* name, const DistanceField& field) {
  return {
      name,
      "distance field, " +
          (field.format() == FieldFormat::int16 ? "int16 of " + number_text(field.quantum_m() * 1e6) + " um"
                                                : std::string("float32")) +
          " in sparse bricks, " + number_text(static_cast<double>(field.bytes()) * 1e-6) + " MB, voxel " +
          number_text(field.voxel_m() * 1e3) + " mm " + reason_of(field.voxel_reason()) +
          ", error of contacts at most " + number_text(field.contact_error_m() * 1e3) +
          " mm on 95 % of the surface and " + number_text(field.error_bound_m() * 1e3) +
          " mm anywhere, thinnest wall " + number_text(field.thinnest_feature_m() * 1e3) + " mm",
      field.bytes()};
}

BuiltPart impact_part(const SceneDesc& desc) {
  std::string what = "new contact regions met at " + number_text(desc.impact.least_speed * 1e3) +
                     " mm/s or more; armed again " + number_text(desc.impact.retreat * 1e3) + " mm off";
  std::size_t bytes = sizeof(ImpactDetector);
  if (desc.scene_objects) {
    what += "; which object is struck, by " + std::to_string(desc.scene_objects->size()) + " samples";
    bytes += desc.scene_objects->bytes();
  }
  return {"impacts", what, bytes};
}

BuiltPart coupling_part(const SceneDesc& desc) {
  std::string rendered =
      number_text(desc.coupling.stiffness * desc.mapping.position_scale * desc.mapping.force_scale) + " N/m";
  if (desc.device.renders_torque)
    rendered +=
        " and " + number_text(desc.coupling.angular_stiffness * desc.mapping.energy_scale()) + " N m/rad";
  return {"coupling",
          number_text(desc.coupling.stiffness) + " N/m, " + number_text(desc.coupling.angular_stiffness) +
              " N m/rad; the device renders " + rendered + free_handle_limit_text(desc),
          sizeof(VirtualCoupling)};
}

BuiltPart holding_part(const SceneDesc& desc) {
  const HoldingPointDesc& holding = *desc.holding_point;
  std::string what = "at " + number_text(holding.place * 1e3) + " mm along the stick unless it is told";
  if (moves_grip(desc.contact.response)) what += "; the coupling's spring is there";
  if (desc.device.structure) what += "; how stiff a wall can be where it touches";
  return {"holding point", what, sizeof(HoldingPoint)};
}

BuiltPart drift_part(const MappingDesc& mapping) {
  return {"workspace drift",
          "by up to " + number_text(mapping.drift * 100) +
              " % of the handle's way, while the tool is free: the hand comes back to the middle",
          sizeof(Vec3)};
}

BuiltPart budget_part(const char* name, const TransientBudget& budget) {
  std::string peak;
  if (budget.peak() > 0) peak = number_text(budget.peak()) + " N";
  if (budget.peak_torque() > 0)
    peak += (peak.empty() ? "" : " and ") + number_text(budget.peak_torque()) + " N m";
  return {name,
          "over any 100 ms: peak " + peak + ", " + number_text(budget.figures().push * 1e3) +
              " ms of it to one side, " + number_text(budget.figures().energy * 1e3) + " mJ to the hand",
          sizeof(TransientBudget) + budget.bytes()};
}

std::size_t bytes_of(const Pointshell& shell) {
  return shell.size() * (2 * sizeof(Vec3) + sizeof(double));
}

}  // namespace

std::vector<BuiltPart> World::parts() const {
  std::vector<BuiltPart> parts;
  if (desc_.tool_shell) {
    const Pointshell& shell = *desc_.tool_shell;
    parts = {field_part("field", *desc_.scene_field),
             {"pointshell",
              std::to_string(shell.size()) + " points, no surface farther than " +
                  number_text(shell.covering_radius_m * 1e3) + " mm from one",
              bytes_of(shell)}};
  }
  if (desc_.scene_edges) {
    const Pointshell& edges = *desc_.scene_edges;
    parts.push_back(
        {"edges", std::to_string(edges.size()) + " points on the scene's sharp edges", bytes_of(edges)});
    parts.push_back(field_part("tool field", *desc_.tool_field));
  }
  const std::vector<BuiltPart> motion = motion_->parts();
  parts.insert(parts.end(), motion.begin(), motion.end());
  if (coupled(desc_.contact.response)) parts.push_back(coupling_part(desc_));
  const std::vector<BuiltPart> always{
      {"estimator",
       std::string("velocity by ").append(name_of(desc_.velocity.kind)) + ", delay " +
           number_text(input_.velocity().delay() * 1e3) + " ms",
       sizeof(VelocityEstimator) + input_.velocity().bytes()},
      {"allocation",
       std::to_string(output_.motors().motors()) + " motors of " + desc_.device.name + ", " +
           std::string(name_of(desc_.allocation.method)),
       sizeof(Allocator)},
      {"safety", "clamp, slew, ramp-in, stop, passivity observer and controller, output limit: always built",
       sizeof(Guard) + sizeof(EncoderMotion) + sizeof(PassivityObserver) + sizeof(PassivityController) +
           sizeof(OutputLimit)},
  };
  parts.insert(parts.end(), always.begin(), always.end());
  if (desc_.mapping.drift > 0) parts.push_back(drift_part(desc_.mapping));
  if (impacts_) parts.push_back(impact_part(desc_));
  if (desc_.holding_point) parts.push_back(holding_part(desc_));
  for (const auto& effect : effects_) parts.push_back(effect->part());
  for (const TransientSource source : transient_sources(desc_, desc_))
    parts.push_back(budget_part(figures_of(source).name, *output_.budget(source)));
  return parts;
}

}  // namespace fulcrum
