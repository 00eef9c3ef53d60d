#include "engine/studies/scene_description.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/assets/sha256.h"
#include "engine/render/studio.h"

namespace fulcrum::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kStudioWidth = 1024, kStudioHeight = 512;  // pixels
constexpr int kSampled =
    12;  // directions across a side of the cube on which the studio counts for the digest

Json triple(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

// Where the values begin in bytes, and how many there are.
template <class T>
Json appended(std::string& bytes, const std::vector<T>& values) {
  const std::size_t first = bytes.size();
  const auto raw = std::as_bytes(std::span(values));
  bytes.append(reinterpret_cast<const char*>(raw.data()), raw.size());
  return {first, values.size()};
}

Json light_json(const std::optional<render::KeyLight>& light) {
  if (!light) return nullptr;
  return {{"kind", light->kind == render::KeyLight::Kind::spot ? "spot" : "directional"},
          {"position", triple(light->position)},
          {"direction", triple(light->direction)},
          {"colour", triple(light->colour)},
          {"intensity", light->intensity},
          {"cone_rad", light->cone_rad},
          {"diameter", light->diameter}};
}

const char* kind_text(render::PunctualLight::Kind kind) {
  switch (kind) {
    case render::PunctualLight::Kind::directional:
      return "directional";
    case render::PunctualLight::Kind::spot:
      return "spot";
    default:
      return "point";
  }
}

// Of models, in the world at this moment.
Json lights_json(const render::VisualDesc& desc, const Shot& shot) {
  Json lights = Json::array();
  for (const render::PunctualLight& light : desc.lights) {
    if ((light.layers & shot.camera.layers) == 0) continue;
    glm::mat4 X_WL(1.0F);
    if (light.carried_by) {
      std::size_t movable = 0;
      for (std::size_t i = 0; i < *light.carried_by; ++i) movable += desc.instances[i].movable ? 1 : 0;
      X_WL = shot.X_WM[movable];
    }
    lights.push_back({{"kind", kind_text(light.kind)},
                      {"position", triple(glm::vec3(X_WL * glm::vec4(light.position, 1.0F)))},
                      {"direction", triple(glm::mat3(X_WL) * light.direction)},
                      {"colour", triple(light.colour)},
                      {"intensity", light.intensity},
                      {"range", light.range ? Json(*light.range) : Json(nullptr)},
                      {"inner_cone_rad", light.inner_cone_rad},
                      {"outer_cone_rad", light.outer_cone_rad}});
  }
  return lights;
}

// A material's colours, finish and relief. Null: it has none of these.
Json pictures_json(const std::optional<render::SurfaceDetail>& detail) {
  if (!detail) return nullptr;
  Json layers;
  const auto add = [&](const char* name, render::SurfaceDetail::Kind kind) {
    const std::optional<render::TextureLayer>& layer = detail->layers[kind];
    if (!layer) return;
    layers[name] = {{"picture", layer->texture},
                    {"uv_set", layer->uv_set},
                    {"repeats", layer->wrap_u == render::Wrap::repeat},
                    {"u", {layer->turn[0][0], layer->turn[1][0], layer->shift.x}},
                    {"v", {layer->turn[0][1], layer->turn[1][1], layer->shift.y}}};
  };
  add("colour", render::SurfaceDetail::base_colour);
  add("finish", render::SurfaceDetail::metal_rough);
  add("relief", render::SurfaceDetail::normal);
  if (layers.contains("relief")) layers["relief"]["scale"] = detail->normal_scale;
  return layers;
}

// Arithmetic alone: the same bits everywhere, which a panorama's sines are not.
std::vector<glm::vec3> studio_samples(const render::Ambient& ambient) {
  std::vector<glm::vec3> samples;
  for (int side = 0; side < 6; ++side)
    for (int i = 0; i < kSampled * kSampled; ++i) {
      const auto along = [](int step) { return static_cast<float>(2 * step + 1) / kSampled - 1.0F; };
      glm::vec3 d;
      d[side / 2] = side % 2 == 0 ? 1.0F : -1.0F;
      d[(side / 2 + 1) % 3] = along(i % kSampled);
      d[(side / 2 + 2) % 3] = along(i / kSampled);
      samples.push_back(render::studio_radiance(ambient, d / std::sqrt(glm::dot(d, d))));
    }
  return samples;
}

// What a scene has its light from, as bright as it is there.
render::Panorama panorama_of(const render::Ambient& ambient) {
  if (!ambient.picture)
    return {kStudioWidth, kStudioHeight, render::studio_panorama(ambient, kStudioWidth, kStudioHeight)};
  render::Panorama picture = *ambient.picture;
  for (glm::vec3& pixel : picture.pixels) pixel *= ambient.intensity;
  return picture;
}

}  // namespace

SceneDescription describe(const render::VisualDesc& desc, const Shot& shot) {
  SceneDescription result;
  Json scene{{"key_light", light_json(desc.key_light)}};
  if (Json lights = lights_json(desc, shot); !lights.empty()) scene["lights"] = lights;
  for (const render::Material& material : desc.materials) {
    Json entry{{"name", material.name},
               {"base_colour", triple(material.base_colour)},
               {"metallic", material.metallic},
               {"roughness", material.roughness}};
    if (Json pictures = pictures_json(material.detail); !pictures.is_null()) entry["pictures"] = pictures;
    if (material.detail && material.detail->scatter_distance != glm::vec3(0.0F))
      entry["scatter_distance"] = triple(material.detail->scatter_distance);
    scene["materials"].push_back(entry);
  }
  for (const render::Texture& texture : desc.textures)
    scene["pictures"].push_back({{"first", appended(result.bytes, texture.rgba)[0]},
                                 {"width", texture.width},
                                 {"height", texture.height},
                                 {"srgb", texture.srgb}});
  Json instances = Json::array(), meshes = Json::array();
  std::size_t movable = 0;
  for (const render::Instance& instance : desc.instances) {
    const glm::mat4 X_WM = instance.movable ? shot.X_WM[movable++] : instance.X_WM;
    if ((instance.layers & shot.camera.layers) == 0) continue;
    Json columns = Json::array();
    for (int i = 0; i < 16; ++i) columns.push_back(X_WM[i / 4][i % 4]);
    const render::Mesh& mesh = desc.meshes[instance.mesh];
    instances.push_back({{"name", instance.name},
                         {"mesh", meshes.size()},
                         {"material", instance.material},
                         {"X_WM", columns}});
    meshes.push_back({{"positions", appended(result.bytes, mesh.positions)},
                      {"normals", appended(result.bytes, mesh.normals)},
                      {"colours", appended(result.bytes, mesh.colours)},
                      {"indices", appended(result.bytes, mesh.indices)}});
    if (!mesh.uv.empty()) meshes.back()["uv"] = appended(result.bytes, mesh.uv);
  }
  scene["instances"] = instances;
  scene["meshes"] = meshes;
  Json kept = shot_json(shot);
  scene["camera"] = kept["camera"];
  Sha256 sum;
  sum.update(scene.dump());
  sum.update(result.bytes);
  const render::Panorama around = panorama_of(desc.ambient);
  const std::vector<glm::vec3> counted = desc.ambient.picture ? around.pixels : studio_samples(desc.ambient);
  sum.update(std::as_bytes(std::span(counted)));
  if (around.seen) sum.update(std::string_view("seen"));
  result.digest = sum.finish_hex();
  kept["digest"] = result.digest;
  scene["shot"] = kept;
  const Json first = appended(result.bytes, around.pixels);
  scene["around"] = {
      {"first", first[0]}, {"width", around.width}, {"height", around.height}, {"seen", around.seen}};
  result.json = scene.dump();
  return result;
}

}  // namespace fulcrum::app
