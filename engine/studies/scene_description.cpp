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

}  // namespace

SceneDescription describe(const render::VisualDesc& desc, const Shot& shot) {
  SceneDescription result;
  Json scene{{"key_light", light_json(desc.key_light)}};
  for (const render::Material& material : desc.materials)
    scene["materials"].push_back({{"name", material.name},
                                  {"base_colour", triple(material.base_colour)},
                                  {"metallic", material.metallic},
                                  {"roughness", material.roughness}});
  std::size_t movable = 0;
  for (const render::Instance& instance : desc.instances) {
    const glm::mat4 X_WM = instance.movable ? shot.X_WM[movable++] : instance.X_WM;
    if ((instance.layers & shot.camera.layers) == 0) continue;
    Json columns = Json::array();
    for (int i = 0; i < 16; ++i) columns.push_back(X_WM[i / 4][i % 4]);
    const render::Mesh& mesh = desc.meshes[instance.mesh];
    scene["instances"].push_back({{"name", instance.name},
                                  {"mesh", scene["meshes"].size()},
                                  {"material", instance.material},
                                  {"X_WM", columns}});
    scene["meshes"].push_back({{"positions", appended(result.bytes, mesh.positions)},
                               {"normals", appended(result.bytes, mesh.normals)},
                               {"colours", appended(result.bytes, mesh.colours)},
                               {"indices", appended(result.bytes, mesh.indices)}});
  }
  Json kept = shot_json(shot);
  scene["camera"] = kept["camera"];
  Sha256 sum;
  sum.update(scene.dump());
  sum.update(result.bytes);
  const std::vector<glm::vec3> studio = studio_samples(desc.ambient);
  sum.update(std::as_bytes(std::span(studio)));
  result.digest = sum.finish_hex();
  kept["digest"] = result.digest;
  scene["shot"] = kept;
  const Json first =
      appended(result.bytes, render::studio_panorama(desc.ambient, kStudioWidth, kStudioHeight));
  scene["studio"] = {{"first", first[0]}, {"width", kStudioWidth}, {"height", kStudioHeight}};
  result.json = scene.dump();
  return result;
}

}  // namespace fulcrum::app
