#include "engine/render/validate.h"

#include <algorithm>
#include <cmath>

#include "engine/render/scatter_taps.h"

namespace fulcrum::render {
using vulkan::Error;

namespace {

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string named(const char* what, const std::string& name, std::size_t index) {
  return std::string(what) + " " + std::to_string(index) + (name.empty() ? "" : " (" + name + ")");
}

std::optional<Error> check_mesh(const Mesh& mesh, std::size_t index) {
  const std::string who = "The " + named("mesh", mesh.name, index);
  if (mesh.positions.empty() || mesh.indices.empty())
    return Error{who + " has no triangles; leave it out of the scene."};
  if (mesh.normals.size() != mesh.positions.size()) {
    return Error{who + " has " + std::to_string(mesh.positions.size()) + " positions and " +
                 std::to_string(mesh.normals.size()) + " normals; give one normal for each position."};
  }
  if (!mesh.colours.empty() && mesh.colours.size() != mesh.positions.size()) {
    return Error{who + " has " + std::to_string(mesh.positions.size()) + " positions and " +
                 std::to_string(mesh.colours.size()) +
                 " colours; give one colour for each position, or none."};
  }
  if (!mesh.uv.empty() && mesh.uv.size() != mesh.positions.size()) {
    return Error{who + " has " + std::to_string(mesh.positions.size()) + " positions and " +
                 std::to_string(mesh.uv.size()) +
                 " places in textures; give one for each position, or none."};
  }
  if (mesh.indices.size() % 3 != 0) {
    return Error{who + " has " + std::to_string(mesh.indices.size()) +
                 " indices, which do not make triangles."};
  }
  for (const std::uint32_t i : mesh.indices) {
    if (i >= mesh.positions.size()) {
      return Error{who + " has the index " + std::to_string(i) + " but only " +
                   std::to_string(mesh.positions.size()) + " positions."};
    }
  }
  for (const glm::vec3& position : mesh.positions)
    if (!finite(position))
      return Error{who + " has a position that is not a number; export the model again."};
  return {};
}

std::optional<Error> check_material(const VisualDesc& desc, std::size_t index) {
  const Material& material = desc.materials[index];
  if (!material.detail) return {};
  for (const auto& layer : material.detail->layers) {
    if (layer && layer->texture >= desc.textures.size())
      return Error{"The " + named("material", material.name, index) + " shows texture " +
                   std::to_string(layer->texture) + ", but there are " +
                   std::to_string(desc.textures.size()) + " textures."};
  }
  const auto& normals = material.detail->layers[SurfaceDetail::normal];
  const auto& colours = material.detail->layers[SurfaceDetail::base_colour];
  if (normals && (desc.textures[normals->texture].srgb || (colours && colours->texture == normals->texture)))
    return Error{"The " + named("material", material.name, index) +
                 " takes its normals from a texture of colours; give them one of their own."};
  const glm::vec3& d = material.detail->scatter_distance;
  if (!finite(d) || glm::any(glm::lessThan(d, glm::vec3(0.0F))))
    return Error{"The " + named("material", material.name, index) +
                 " says that light spreads below it by what is no distance; give metres, 0 or more."};
  return {};
}

std::optional<Error> check_texture(const Texture& texture, std::size_t index) {
  constexpr std::uint32_t kLargest = 8192;
  const bool fits = texture.width > 0 && texture.height > 0 && texture.width <= kLargest &&
                    texture.height <= kLargest &&
                    texture.rgba.size() == std::size_t{4} * texture.width * texture.height;
  if (fits) return {};
  return Error{"The " + named("texture", texture.name, index) +
               " has no pixels, other than its size says, or more than 8192 a side; make it again."};
}

// first: instance of each mesh, as far as they have been looked at.
std::optional<Error> check_instance(const VisualDesc& desc, std::size_t index,
                                    std::vector<std::optional<std::size_t>>& first) {
  const Instance& instance = desc.instances[index];
  const std::string who = "The " + named("instance", instance.name, index);
  if (instance.mesh >= desc.meshes.size()) {
    return Error{who + " shows mesh " + std::to_string(instance.mesh) + ", but there are " +
                 std::to_string(desc.meshes.size()) + " meshes."};
  }
  if (instance.material >= desc.materials.size()) {
    return Error{who + " is made of material " + std::to_string(instance.material) + ", but there are " +
                 std::to_string(desc.materials.size()) + " materials."};
  }
  std::optional<std::size_t>& same = first[instance.mesh];
  if (!same) same = index;
  if (desc.instances[*same].layers != instance.layers) {
    return Error{who + " is on other layers than instance " + std::to_string(*same) +
                 ", which shows the same mesh; give it a mesh of its own."};
  }
  const float volume = glm::determinant(glm::mat3(instance.X_WM));
  if (!std::isfinite(volume) || volume <= 0.0F) {
    return Error{
        who +
        " has a transform that mirrors or flattens it; use a rotation, a translation and a positive scale."};
  }
  return {};
}

// The sum of such lights near by, as a mirror shows it, is still a number.
constexpr float kBrightestLight = 1e9F;

std::optional<Error> check_light(const VisualDesc& desc, std::size_t index) {
  const PunctualLight& light = desc.lights[index];
  const std::string who = "The " + named("light", light.name, index);
  const bool sound = finite(light.position) && finite(light.direction) && finite(light.colour) &&
                     light.intensity >= 0.0F && light.intensity <= kBrightestLight &&
                     light.range.value_or(1.0F) > 0.0F;
  if (!sound)
    return Error{who + " needs finite numbers, an intensity of 0 to a billion and a range above 0 m."};
  if (light.kind != PunctualLight::Kind::point && !(glm::length(light.direction) > 0.0F))
    return Error{who + " has no direction; give the way its light travels, such as 0 -1 0."};
  if (!(light.inner_cone_rad >= 0.0F && light.inner_cone_rad <= light.outer_cone_rad))
    return Error{who + " begins to fade outside the cone where it ends; let its inner cone be the smaller."};
  if (light.carried_by &&
      (*light.carried_by >= desc.instances.size() || !desc.instances[*light.carried_by].movable))
    return Error{who + " is carried by instance " + std::to_string(*light.carried_by) +
                 ", which is none that moves."};
  return {};
}

std::optional<Error> check_panorama(const Panorama& picture) {
  if (picture.width == 0 || picture.width > 8192 || picture.width != 2 * picture.height ||
      picture.pixels.size() != std::size_t{picture.width} * picture.height)
    return Error{
        "The picture of the surroundings has no size of its own, or is not twice as wide as high; give " +
        std::string("1 to 4096 rows, each of twice as many pixels.")};
  for (const glm::vec3& pixel : picture.pixels)
    if (!finite(pixel) || glm::any(glm::lessThan(pixel, glm::vec3(0.0F))))
      return Error{
          "The picture of the surroundings has a pixel that is no amount of light; export it again."};
  return {};
}

}  // namespace

std::optional<Error> validate(const VisualDesc& desc) {
  for (std::size_t i = 0; i < desc.meshes.size(); ++i)
    if (auto error = check_mesh(desc.meshes[i], i)) return *error;
  for (std::size_t i = 0; i < desc.textures.size(); ++i)
    if (auto error = check_texture(desc.textures[i], i)) return *error;
  for (std::size_t i = 0; i < desc.materials.size(); ++i)
    if (auto error = check_material(desc, i)) return *error;
  std::vector<std::optional<std::size_t>> first(desc.meshes.size());
  for (std::size_t i = 0; i < desc.instances.size(); ++i)
    if (auto error = check_instance(desc, i, first)) return *error;
  if (desc.lights.size() > kMostLights)
    return Error{"The scene has " + std::to_string(desc.lights.size()) +
                 " lights beside its key light; use " + std::to_string(kMostLights) + " at most."};
  for (std::size_t i = 0; i < desc.lights.size(); ++i)
    if (auto error = check_light(desc, i)) return *error;
  if (const std::size_t count = scatter_distances(desc).size(); count > kMostScattering)
    return Error{"The scene has " + std::to_string(count) + " instances that light spreads below; " +
                 std::to_string(kMostScattering) +
                 " can be told apart: leave out 'scatter_distance' where "
                 "it is not seen."};
  for (std::size_t i = 0; i < desc.markers.size(); ++i) {
    const Marker& marker = desc.markers[i];
    if (!(marker.radius > 0.0F) || !finite(marker.position)) {
      return Error{"The " + named("marker", marker.name, i) +
                   " needs a finite position and a radius above 0 m."};
    }
  }
  if (!desc.ghosts.empty() &&
      std::none_of(desc.instances.begin(), desc.instances.end(),
                   [](const Instance& instance) { return instance.movable && instance.follows == 0; })) {
    return Error{
        "The scene has a ghost, but nothing movable that it could be a copy of; leave out the ghost."};
  }
  for (const Ghost& ghost : desc.ghosts) {
    if (!(ghost.line_width > 0.0F && ghost.line_width <= 0.05F)) {
      return Error{"The ghost's lines are " + std::to_string(ghost.line_width) +
                   " of the picture's height wide; use more than 0 and at most 0.05."};
    }
  }
  if (desc.ambient.picture)
    if (auto error = check_panorama(*desc.ambient.picture)) return *error;
  if (desc.key_light && !(glm::length(desc.key_light->direction) > 0.0F))
    return Error{"The key light has no direction; give the way its light travels, such as 0 -1 0."};
  return {};
}

}  // namespace fulcrum::render
