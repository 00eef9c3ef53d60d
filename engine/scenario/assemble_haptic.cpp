#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

#include "engine/scenario/assemble.h"
#include "haptics/bake/mirrored.h"
#include "haptics/bake/surface_samples.h"
#include "haptics/effects/effects.h"
#include "haptics/math/mirror.h"
#include "haptics/world/couple_without_motors.h"

namespace fulcrum::scenario {

namespace {

// What is baked are the models as their files have them, whichever hand holds the tool; of a scene for the
// left hand, the image of what is baked is taken.
TriangleMesh as_made(const Scenario& scenario, const Model& model) {
  TriangleMesh mesh = to_triangle_mesh(model);
  return scenario.left_handed ? mirrored(std::move(mesh)) : mesh;
}

template <class T>
void take_image(const Scenario& scenario, Result<Baked<T>>& baked) {
  if (baked && scenario.left_handed) baked->value = mirrored(std::move(baked->value));
}

// What is touched and what touches, as made.
struct Solids {
  Solid scene, tool;
};

// Of the models that are touched, by their numbers. otherwise: of those that name none.
std::vector<ImpactMaterial> materials_of(const Scenario& scenario, const std::string& otherwise) {
  std::vector<ImpactMaterial> materials;
  for (const ModelEntry& model : scenario.models) {
    if (model.role != ModelRole::scene) continue;
    materials.push_back(scenario.impact_materials.at(model.material.empty() ? otherwise : model.material));
  }
  return materials;
}

bool sounds_apart(const std::vector<ImpactMaterial>& heard) {
  return std::ranges::any_of(
      heard, [&](const ImpactMaterial& each) { return each.name != heard.front().name; });
}

// About this many samples in all, whatever the scene's size.
constexpr double kObjectSamples = 20000;

std::shared_ptr<const ObjectMap> objects_of(const Scenario& scenario, const LoadedModels& models) {
  std::vector<TriangleMesh> meshes;
  double area = 0;
  for (std::size_t i = 0; i < scenario.models.size(); ++i) {
    if (scenario.models[i].role != ModelRole::scene) continue;
    area += surface_area(meshes.emplace_back(as_made(scenario, models.models[i])));
  }
  if (meshes.size() < 2) return nullptr;
  std::vector<Vec3> samples;
  std::vector<std::int32_t> objects;
  for (std::size_t object = 0; object < meshes.size(); ++object) {
    for (SurfacePoint& point : sample_surface(meshes[object], area / kObjectSamples, 1).points) {
      if (scenario.left_handed) fulcrum::mirror(point.position);
      samples.push_back(point.position);
      objects.push_back(static_cast<std::int32_t>(object));
    }
  }
  return std::make_shared<const ObjectMap>(samples, objects);
}

// Wraps a bake: tells the progress and notes how the result came about.
class Baking {
public:
  Baking(std::string_view what, const BakeProgress& progress) : what_(what), progress_(progress) { tell(0); }

  // Tells of whole percents: a bake reports far more often than anyone can look.
  void tell(double fraction) {
    const int percent = static_cast<int>(100 * fraction);
    if (percent == told_percent_) return;
    told_percent_ = percent;
    if (progress_) progress_(what_, fraction);
  }

  template <class T>
  void finish(const Baked<T>& baked, const std::string& size, HapticAssembly& result) {
    tell(1);
    char seconds[32];
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin_;
    std::snprintf(seconds, sizeof seconds, "%.2f s", taken.count());
    const std::string how = baked.from_cache ? "from the cache in " : "baked in ";
    result.notes.push_back(std::string(what_) + " (" + size + ") " + how + seconds);
    std::vector<std::string>& warnings = result.warnings;
    const bool told = std::ranges::find(warnings, baked.note) != warnings.end();  // by the bake before
    if (!baked.note.empty() && !told) warnings.push_back(baked.note);
  }

private:
  std::string_view what_;
  const BakeProgress& progress_;
  int told_percent_ = -1;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

ToolDesc tool_desc(const ToolEntry& entry, const LoadedModels& models, const Pose& X_MT) {
  ToolDesc tool;
  if (entry.mass) tool.mass = *entry.mass;
  if (entry.density) tool.mass = *entry.density * models.tool.volume_m3;
  tool.inertia_T = models.tool.inertia * (tool.mass / models.tool.volume_m3);
  tool.X_HT = entry.X_HM * X_MT;
  tool.X_WT_start = entry.X_WM_start * X_MT;
  tool.weight = entry.weight;
  return tool;
}

// What of the scene could go in between the shell's points, and a field of the tool to look it up in.
std::optional<Error> assemble_edges(const Scenario& scenario, const BakeCache& cache,
                                    const BakeProgress& progress, const Solids& solids,
                                    HapticAssembly& result) {
  Baking edges_baking("scene's edges", progress);
  auto edges = cache.edges(solids.scene, {.spacing_m = scenario.edges});
  take_image(scenario, edges);
  if (!edges) return Error{"contact.edges: " + edges.error().sentence};
  edges_baking.finish(*edges, std::to_string(edges->value.size()) + " points", result);
  result.scene.scene_edges = std::make_shared<const Pointshell>(std::move(edges->value));

  Baking field_baking("tool's distance field", progress);
  auto field = cache.field(solids.tool, {.format = scenario.field.format, .error_m = scenario.field.error_m},
                           [&](double fraction) { field_baking.tell(fraction); });
  take_image(scenario, field);
  if (!field) return Error{"contact.edges: the tool's distance field: " + field.error().sentence};
  field_baking.finish(*field, std::to_string(field->value.bytes() >> 20) + " MiB", result);
  result.scene.tool_field = std::make_shared<const DistanceField>(std::move(field->value));
  return std::nullopt;
}

// The response measures contact on triangles.
bool on_triangles(const Scenario& scenario) {
  return scenario.surface == ContactSurface::triangles &&
         scenario.contact.response == ContactResponse::constraint;
}

// The tool's points, and the scene's field to look them up in.
std::optional<Error> assemble_points(const Scenario& scenario, const BakeCache& cache,
                                     const BakeProgress& progress, const Solids& solids,
                                     HapticAssembly& result) {
  Baking shell_baking("pointshell", progress);
  auto shell = cache.pointshell(solids.tool, scenario.shell);
  take_image(scenario, shell);
  if (!shell) return Error{"the tool's pointshell: " + shell.error().sentence};
  shell_baking.finish(*shell, std::to_string(shell->value.size()) + " points", result);
  result.scene.tool_shell = std::make_shared<const Pointshell>(std::move(shell->value));

  Baking field_baking("distance field", progress);
  auto field =
      cache.field(solids.scene, scenario.field, [&](double fraction) { field_baking.tell(fraction); });
  take_image(scenario, field);
  if (!field) return Error{"the scene's distance field: " + field.error().sentence};
  field_baking.finish(*field, std::to_string(field->value.bytes() >> 20) + " MiB", result);
  result.scene.scene_field = std::make_shared<const DistanceField>(std::move(field->value));
  return std::nullopt;
}

// The triangles of both, in place of points.
void assemble_features(HapticAssembly& result) {
  const auto begin = std::chrono::steady_clock::now();
  const auto features_of = [](const Solid& solid) {
    return std::make_shared<const FeatureMesh>(solid.mesh, solid.neighbours);
  };
  result.scene.tool_features = features_of(result.tool_T);
  result.scene.scene_features = features_of(result.scene_W);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  char note[96];
  std::snprintf(note, sizeof note, "features (%zu triangles and %zu) made in %.2f s",
                result.tool_T.mesh.triangles.size(), result.scene_W.mesh.triangles.size(), taken.count());
  result.notes.emplace_back(note);
}

}  // namespace

Checked<Solid> build_scene_solid(const Scenario& scenario, const LoadedModels& models) {
  TriangleMesh all;
  std::vector<std::size_t> touched;
  for (std::size_t i = 0; i < scenario.models.size(); ++i) {
    if (scenario.models[i].role != ModelRole::scene) continue;
    touched.push_back(i);
    const TriangleMesh mesh = as_made(scenario, models.models[i]);
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  auto solid = build_solid(all);
  if (!solid) {
    Faults faults;
    for (const std::size_t i : touched) {
      const ModelEntry& entry = scenario.models[i];
      const auto alone = build_solid(as_made(scenario, models.models[i]));
      if (!alone)
        faults.push_back(entry.file.where.fault("model '" + entry.name + "': " + alone.error().sentence));
    }
    if (faults.empty())
      faults.push_back(scenario.models[touched.front()].file.where.fault(
          "the models that are touched, together: " + solid.error().sentence));
    return faults;
  }
  for (std::string& note : solid->notes) note.insert(0, "the models that are touched: ");
  return std::move(*solid);
}

Result<HapticAssembly> assemble_haptic(const Scenario& scenario, const LoadedModels& models,
                                       const BakeCache& cache, const BakeProgress& progress) {
  HapticAssembly result;
  result.notes = models.notes;
  result.tool_T = models.tool_T;
  auto solid = build_scene_solid(scenario, models);
  if (!solid) return Error{to_text(solid.faults())};
  const Solids solids{std::move(*solid), scenario.left_handed ? mirrored(models.tool_T) : models.tool_T};
  result.scene_W = scenario.left_handed ? mirrored(solids.scene) : solids.scene;
  for (const Fault& repaired : models.repaired) result.repaired.push_back(repaired.text());
  result.repaired.insert(result.repaired.end(), result.scene_W.notes.begin(), result.scene_W.notes.end());

  const Pose X_MT{Quat::Identity(), models.p_MT};
  SceneDesc& scene = result.scene;
  scene.tick_s = 1 / scenario.tick_rate_Hz;
  scene.tool = tool_desc(scenario.tool, models, X_MT);
  scene.contact = scenario.contact;
  scene.integrator = scenario.integrator;
  scene.velocity = scenario.velocity_estimator;
  scene.mapping = scenario.device.mapping;
  scene.device = scenario.device.desc;
  scene.allocation = scenario.device.allocation;
  scene.impact = scenario.impact;
  static_cast<EffectDescs&>(scene) = scenario.effects;
  if (!scenario.impact_material.empty())
    set_materials(scene, materials_of(scenario, scenario.impact_material));
  scene.holding_point = scenario.holding_point;
  const bool felt_apart = tells_objects_apart(scene, scene);
  if (scenario.sound) result.heard = materials_of(scenario, scenario.sound->material);
  if (felt_apart || sounds_apart(result.heard)) result.objects = objects_of(scenario, models);
  if (felt_apart) scene.scene_objects = result.objects;
  scene.coupling = tune_coupling(scenario.coupling, scene);
  if (const auto warning = beyond_limits(scene)) result.warnings.push_back(*warning);
  for (const std::string& warning : advice_on_effects(scene, scene)) result.warnings.push_back(warning);

  // Beside the response, impacts are told apart by the tool's points and the scene's field.
  if (!on_triangles(scenario) || may_ask_for_impacts(scenario.effects)) {
    if (const auto error = assemble_points(scenario, cache, progress, solids, result)) return *error;
  }
  if (on_triangles(scenario)) {
    assemble_features(result);
  } else if (scenario.edges > 0 && scenario.contact.response == ContactResponse::constraint) {
    if (const auto error = assemble_edges(scenario, cache, progress, solids, result)) return *error;
  }
  couple_without_motors(scene);

  result.task = {scenario.checkpoints,     scenario.dwell,      scenario.tool.touch_point - models.p_MT,
                 scenario.tool.touch_name, scenario.hard_touch, scenario.order,
                 scenario.avoid,           scenario.score};
  for (const HandEntry& hand : scenario.hands) {
    HandScript script{hand.name, hand.desc, hand.waypoints};
    for (Waypoint& waypoint : script.waypoints) waypoint.X_WT = waypoint.X_WT * X_MT;
    if (hand.name == kExpertHand) set_expert(scene, script.waypoints);
    result.hands.push_back(std::move(script));
  }
  return result;
}

}  // namespace fulcrum::scenario
