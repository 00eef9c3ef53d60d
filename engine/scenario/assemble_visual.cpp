#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/turned.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/decor_shadows.h"
#include "engine/scenario/device_shapes.h"
#include "engine/scenario/holding_axes.h"
#include "engine/scenario/level_bars.h"
#include "engine/scenario/model_lights.h"
#include "engine/scenario/surfaces.h"
#include "engine/scenario/surroundings_file.h"
#include "engine/scenario/to_glm.h"
#include "engine/scenario/words.h"
#include "haptics/actuation/mechanism.h"
#include "haptics/effects/effects.h"

namespace fulcrum::scenario {

namespace {

// Of a bar that shows where to go: of the radius there, and m.
constexpr double kWayOfRadius = 0.15, kThickestWay = 0.001;

render::Mesh mesh_of(const ModelPart& part, const Vec3& origin) {
  render::Mesh mesh;
  mesh.name = part.name;
  mesh.indices = part.indices;
  for (const Vec3& p : part.positions) mesh.positions.push_back(narrowed(p - origin));
  for (const Vec3& n : part.normals) mesh.normals.push_back(narrowed(n));
  for (const Vec3& c : part.colours) mesh.colours.push_back(narrowed(c));
  for (const auto& uv : part.uv) mesh.uv.emplace_back(uv[0], uv[1], uv[2], uv[3]);
  return mesh;
}

// Every material of that name in any of the models; a name that none has is a slip.
std::optional<Fault> apply(const MaterialOverride& override, std::vector<render::Material>& materials) {
  bool applied = false;
  for (render::Material& material : materials) {
    if (material.name != override.name) continue;
    applied = true;
    if (override.base_colour) material.base_colour = narrowed(*override.base_colour);
    if (override.metallic) material.metallic = static_cast<float>(*override.metallic);
    if (override.roughness) material.roughness = static_cast<float>(*override.roughness);
    const bool is_metal = !material.detail && material.metallic >= 1.0F;  // which no light enters
    if (override.scatter_distance != Vec3::Zero() && !is_metal) {
      if (!material.detail) material.detail.emplace();
      material.detail->scatter_distance = narrowed(override.scatter_distance);
    }
  }
  if (applied) return std::nullopt;
  std::vector<std::string_view> names;
  for (const render::Material& material : materials)
    if (std::ranges::find(names, material.name) == names.end()) names.push_back(material.name);
  return override.where.fault("no model has a material " + in_quotes(override.name) +
                              did_you_mean(override.name, names, "there is: " + joined(names)));
}

constexpr glm::vec3 kExpertColour{0.45F, 0.95F, 0.10F};  // linear, of the expert's tool

// Layers: what cameras of whole views see, and those of views that are cut open.
constexpr std::uint32_t kWhole = 1, kCut = 2;

std::uint32_t layers_of(const ModelEntry& entry, const std::vector<ModelEntry>& models) {
  if (!entry.cut_of.empty()) return kCut;
  return std::ranges::count(models, entry.name, &ModelEntry::cut_of) > 0 ? kWhole : kWhole | kCut;
}

// Appends the model's materials, parts and lights; those of the tool are moved to T and movable. A fault
// where what is laid onto it cannot be used.
std::optional<Fault> add_model(render::VisualDesc& desc, const ModelEntry& entry, const Model& model,
                               const Vec3& p_MT, const Pose& X_WT_start, std::uint32_t layers, bool drawn) {
  const bool is_tool = entry.role == ModelRole::tool;
  const std::size_t first_material = desc.materials.size();
  if (const auto refused = add_materials(desc, model)) {
    const FileRef& file = entry.drawn.name.empty() ? entry.file : entry.drawn;
    return file.where.fault("model '" + entry.name + "': " + in_quotes(file.name) + ": " + refused->sentence);
  }
  if (!drawn) return std::nullopt;
  const std::size_t first_instance = desc.instances.size();
  for (const ModelPart& part : model.parts) {
    render::Instance instance;
    instance.mesh = desc.meshes.size();
    instance.material = first_material + part.material;
    instance.name = entry.name + "/" + part.name;
    instance.X_WM = is_tool ? to_glm(X_WT_start) : glm::mat4(1.0F);
    instance.movable = is_tool;
    instance.casts_shadow = entry.role != ModelRole::decor || !entry.cut_of.empty();
    instance.layers = layers;
    desc.instances.push_back(std::move(instance));
    desc.meshes.push_back(mesh_of(part, is_tool ? p_MT : Vec3::Zero()));
  }
  // Those of the tool lie in T, as all its instances do.
  add_lights(desc, model.lights, is_tool ? p_MT : Vec3::Zero(),
             is_tool ? std::optional(first_instance) : std::nullopt, layers);
  return std::nullopt;
}

// What a checkpoint's touch point has to go along, as a thin bar from corner to corner.
void add_way(render::VisualDesc& desc, const Checkpoint& checkpoint, std::uint32_t layers) {
  std::vector<Vec3> corners{checkpoint.position};
  std::ranges::copy(checkpoint.follow, std::back_inserter(corners));
  if (checkpoint.insert)
    corners.push_back(checkpoint.position + checkpoint.insert->depth * checkpoint.insert->direction_W);
  const auto thick = static_cast<float>(std::min(kWayOfRadius * checkpoint.radius, kThickestWay));
  render::Mesh mesh;
  mesh.name = "way of " + checkpoint.name;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    render::add_bar(mesh, narrowed(corners[i]), narrowed(corners[i + 1]), thick, thick);
    render::add_ball(mesh, narrowed(corners[i + 1]), thick);
  }
  render::Instance instance;
  instance.mesh = desc.meshes.size();
  instance.material = desc.materials.size();
  instance.name = mesh.name;
  instance.casts_shadow = false;
  instance.layers = layers;
  desc.materials.push_back({mesh.name, {0.03F, 0.33F, 0.68F}, 0.0F, 0.5F});
  desc.meshes.push_back(std::move(mesh));
  desc.instances.push_back(std::move(instance));
}

}  // namespace

bool draws_arms(const Scenario& scenario, const SceneDesc& scene) {
  return scenario.device.drawn && scene.device.kinematics == Kinematics::arms;
}

bool draws_levels(const SceneDesc& scene) {
  const std::optional<ChannelUse> use = channel_use(scene, scene);
  return use && use->axis_W;
}

Checked<VisualAssembly> assemble_visual(const Scenario& scenario, const LoadedModels& models,
                                        const SceneDesc& scene) {
  Faults faults;
  VisualAssembly result;
  render::VisualDesc& desc = result.desc;
  const Pose X_WT_start = scenario.tool.X_WM_start * Pose{Quat::Identity(), models.p_MT};
  for (std::size_t i = 0; i < scenario.models.size(); ++i) {
    const ModelEntry& entry = scenario.models[i];
    if (const auto fault = add_model(desc, entry, models.drawn[i] ? *models.drawn[i] : models.models[i],
                                     models.p_MT, X_WT_start, layers_of(entry, scenario.models),
                                     !(scenario.left_handed && entry.lettering)))
      faults.push_back(*fault);
  }
  for (const MaterialOverride& material : scenario.materials)
    if (const auto fault = apply(material, desc.materials)) faults.push_back(*fault);
  if (scenario.light) let_decor_throw_shadows(desc, *scenario.light);
  if (draws_arms(scenario, scene)) {
    if (const auto refused = Mechanism::refuse(scene.device.mechanism))
      faults.push_back({"devices/" + scenario.device.model + ".yaml", 0, 0, refused->sentence});
    else
      add_device_arms(desc, scene.device.mechanism, scene.mapping, scenario.device.floor, kWhole | kCut);
  }
  if (scenario.guide) add_guide(desc, *scenario.guide, kWhole | kCut);
  if (scene.holding_point) add_holding_axes(desc, kWhole | kCut);
  if (draws_levels(scene)) add_level_bars(desc, kWhole | kCut);
  for (const Checkpoint& checkpoint : scenario.checkpoints) {
    desc.markers.push_back(
        {checkpoint.name, narrowed(checkpoint.position), static_cast<float>(checkpoint.radius)});
    if (is_way(checkpoint)) add_way(desc, checkpoint, kWhole | kCut);
  }
  for (const Avoided& ball : scenario.avoid)
    desc.markers.push_back({ball.name, narrowed(ball.position), static_cast<float>(ball.radius)});
  desc.key_light = scenario.light;
  desc.ambient = scenario.ambient;
  if (scenario.surroundings) {
    Checked<render::Panorama> read = read_surroundings(scenario, *scenario.surroundings);
    if (read)
      desc.ambient.picture = std::move(*read);
    else
      faults.insert(faults.end(), read.faults().begin(), read.faults().end());
  }
  if (!faults.empty()) return faults;
  desc.background = scenario.background;
  // The bridge gives their poses in this order.
  if (shows_ghost(scene, scene)) desc.ghosts.push_back({});
  if (follows_expert(scene)) desc.ghosts.push_back({.colour = kExpertColour});
  result.views = scenario.views;
  for (View& view : result.views) view.camera.layers = view.cut ? kCut : kWhole;
  if (!result.views.empty()) desc.camera = result.views.front().camera;
  return result;
}

}  // namespace fulcrum::scenario
