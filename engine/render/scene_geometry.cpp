#include "engine/render/scene_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "engine/render/look.h"
#include "engine/render/scatter_taps.h"
#include "engine/render/vertex.h"

namespace fulcrum::render {
namespace {

void write_pose(gpu::InstanceData& to, const glm::mat4& X_WM) {
  const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(X_WM)));
  to.world_from_mesh = X_WM;
  to.normal_x = glm::vec4(normals[0], 0.0F);
  to.normal_y = glm::vec4(normals[1], 0.0F);
  to.normal_z = glm::vec4(normals[2], 0.0F);
}

std::array<std::uint16_t, 4> to_vertex(const glm::vec3& colour) {
  const glm::vec3 scaled = static_cast<float>(Vertex::kOne) * glm::clamp(colour, 0.0F, 1.0F) + 0.5F;
  return {static_cast<std::uint16_t>(scaled.r), static_cast<std::uint16_t>(scaled.g),
          static_cast<std::uint16_t>(scaled.b), Vertex::kOne};
}

gpu::InstanceData to_gpu(const Instance& instance, const Material& material) {
  gpu::InstanceData made{};
  write_pose(made, instance.X_WM);
  made.base_colour = glm::vec4(material.base_colour, 1.0F);
  made.surface = {material.metallic, material.roughness, 0.0F, 0.0F};
  return made;
}

// What a length in it becomes, at the most, where its axes stay at right angles.
float largest_scale(const glm::mat4& X) {
  return std::sqrt(std::max({glm::dot(X[0], X[0]), glm::dot(X[1], X[1]), glm::dot(X[2], X[2])}));
}

}  // namespace

SceneGeometry::SceneGeometry(vulkan::Device& device, const VisualDesc& desc)
    : instances_(device, desc.instances.size() * sizeof(gpu::InstanceData),
                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Place::upload) {
  upload_meshes(device, desc);
  sort_instances(desc);
}

SceneGeometry::Place SceneGeometry::place_of(const Mesh& mesh, std::size_t first_index,
                                             std::size_t first_vertex) {
  const auto first = static_cast<std::uint32_t>(first_index);
  Place place;
  place.whole = {first, static_cast<std::uint32_t>(mesh.indices.size()), 0.0F};
  place.first_vertex = static_cast<std::int32_t>(first_vertex);
  if (mesh.levels) place.pieces = mesh.levels->pieces;
  for (LevelsOfDetail::Piece& piece : place.pieces)
    for (LevelsOfDetail::Level& level : piece.levels) level.first += first;
  if (place.pieces.empty()) place.pieces.push_back({bounds_of(mesh.positions), {place.whole}});
  return place;
}

// Meshes with places in textures come first: a vertex has one number in both buffers.
void SceneGeometry::upload_meshes(vulkan::Device& device, const VisualDesc& desc) {
  std::vector<bool> is_placed(desc.meshes.size(), false);
  for (const Instance& instance : desc.instances)
    if (reads_places(look_of(desc.materials[instance.material]).value_or(0))) is_placed[instance.mesh] = true;
  places_.resize(desc.meshes.size());
  std::vector<Vertex> vertices;
  std::vector<glm::vec4> uv;
  std::vector<std::uint32_t> indices;
  for (const bool placed : {true, false}) {
    for (std::size_t m = 0; m < desc.meshes.size(); ++m) {
      if (is_placed[m] != placed) continue;
      const Mesh& mesh = desc.meshes[m];
      places_[m] = place_of(mesh, indices.size(), vertices.size());
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        Vertex vertex{.position = mesh.positions[i], .normal = mesh.normals[i]};
        if (!mesh.colours.empty()) vertex.colour = to_vertex(mesh.colours[i]);
        vertices.push_back(vertex);
      }
      if (placed && !mesh.uv.empty()) uv.insert(uv.end(), mesh.uv.begin(), mesh.uv.end());
      if (placed) uv.resize(vertices.size(), glm::vec4(0.0F));
      const std::vector<std::uint32_t>& triangles = mesh.levels ? mesh.levels->indices : mesh.indices;
      indices.insert(indices.end(), triangles.begin(), triangles.end());
    }
  }
  vertices_ = vulkan::upload(device, std::as_bytes(std::span(vertices)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  if (!uv.empty())
    uv_ = vulkan::upload(device, std::as_bytes(std::span(uv)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  indices_ = vulkan::upload(device, std::as_bytes(std::span(indices)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

void SceneGeometry::sort_instances(const VisualDesc& desc) {
  const auto kind_of = [&](const Instance& instance) {
    return desc.materials[instance.material].detail ? std::optional(instance.material) : std::nullopt;
  };
  std::vector<std::size_t> order(desc.instances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Instance &left = desc.instances[a], &right = desc.instances[b];
    return std::tuple(left.mesh, kind_of(left), left.movable, !left.casts_shadow) <
           std::tuple(right.mesh, kind_of(right), right.movable, !right.casts_shadow);
  });
  std::vector<Bounds> mesh_bounds;
  for (const Mesh& mesh : desc.meshes) mesh_bounds.push_back(bounds_of(mesh.positions));
  const std::vector<std::uint32_t> scattering = scatter_numbers(desc);
  std::vector<std::uint32_t> slot_of(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto slot = static_cast<std::uint32_t>(i);
    const Instance& instance = desc.instances[order[i]];
    const Material& material = desc.materials[instance.material];
    const std::optional<std::size_t> kind = kind_of(instance);
    if (batches_.empty() || batches_.back().mesh != instance.mesh || batches_.back().material != kind ||
        batches_.back().movable != instance.movable) {
      batches_.push_back({instance.mesh, kind, look_of(material).value_or(0), instance.movable, slot, 0, 0,
                          false, instance.layers});
    }
    Batch& batch = batches_.back();
    const bool casts = throws_shadow(instance, material);
    slot_of[order[i]] = slot;
    slots_.push_back({.mesh_bounds = mesh_bounds[instance.mesh],
                      .box = is_blended(batch.look) ? oriented_box_of(desc.meshes[instance.mesh].positions)
                                                    : OrientedBox(),
                      .X_WM = instance.X_WM,
                      .casts = casts,
                      .layers = instance.layers});
    data()[slot] = to_gpu(instance, material);
    data()[slot].surface.z = static_cast<float>(scattering[order[i]]);
    batch.count += 1;
    batch.casters += casts ? 1 : 0;
    batch.tool = batch.tool || (instance.movable && instance.follows == 0);
  }
  for (std::size_t i = 0; i < order.size(); ++i)
    if (desc.instances[i].movable) movable_slots_.push_back(slot_of[i]);
}

bool SceneGeometry::place(std::span<const glm::mat4> X_WM) {
  bool caster_moved = false;
  for (std::size_t i = 0; i < movable_slots_.size(); ++i) {
    Slot& slot = slots_[movable_slots_[i]];
    if (slot.X_WM != X_WM[i]) {
      slot.X_WM = X_WM[i];
      caster_moved = caster_moved || slot.casts;
      write_pose(data()[movable_slots_[i]], X_WM[i]);
    }
  }
  return caster_moved;
}

std::vector<Bounds> SceneGeometry::casters(std::uint32_t layers) const {
  std::vector<Bounds> boxes;
  for (const Slot& slot : slots_)
    if (slot.casts && (slot.layers & layers) != 0) boxes.push_back(transformed(slot.mesh_bounds, slot.X_WM));
  return boxes;
}

bool SceneGeometry::casts_alike(std::uint32_t layers, std::uint32_t others) const {
  return std::ranges::none_of(
      slots_,
      [&](const Slot& slot) {
        return slot.casts && ((slot.layers & layers) != 0) != ((slot.layers & others) != 0);
      });
}

bool SceneGeometry::is_among(const Batch& batch, Casters which) {
  return batch.casters > 0 && (which == Casters::all || batch.movable == (which == Casters::moving));
}

void SceneGeometry::draw_casters(VkCommandBuffer commands, Casters which, const Sight& light) const {
  bind(commands);
  for (std::size_t i = 0; i < batches_.size(); ++i) {
    const Batch& batch = batches_[i];
    if ((batch.layers & light.layers) == 0 || !is_among(batch, which) || is_masked(batch.look)) continue;
    vkCmdSetCullMode(commands, is_two_sided(batch.look) ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
    Piece casting = piece_of(batch, i);
    casting.count = batch.casters;
    draw(commands, casting, light);
  }
}

void SceneGeometry::bind(VkCommandBuffer commands) const {
  const std::array<VkBuffer, 2> buffers = {vertices_.get(), uv_.get()};
  const std::array<VkDeviceSize, 2> offsets = {0, 0};
  vkCmdBindVertexBuffers(commands, 0, uv_.get() == VK_NULL_HANDLE ? 1 : 2, buffers.data(), offsets.data());
  vkCmdBindIndexBuffer(commands, indices_.get(), 0, VK_INDEX_TYPE_UINT32);
}

void SceneGeometry::add_draws(const Piece& piece, const Sight& sight, std::vector<Draw>& draws) const {
  const auto slots = std::span(slots_).subspan(piece.first_slot, piece.count);
  for (const LevelsOfDetail::Piece& part : places_[batches_[piece.batch].mesh].pieces) {
    bool seen = false;
    Draw draw{std::numeric_limits<float>::infinity(), part.levels.front(), piece};
    float tolerance = draw.distance;
    for (const Slot& slot : slots) {
      const Bounds box = transformed(part.bounds, slot.X_WM);
      if (!sight.sees(box)) continue;
      seen = true;
      draw.distance = std::min(draw.distance, sight.distance(box));
      tolerance = std::min(tolerance, sight.tolerance(box) / largest_scale(slot.X_WM));
    }
    if (!seen) continue;
    for (const LevelsOfDetail::Level& level : part.levels)
      if (level.error <= tolerance) draw.level = level;
    draws.push_back(draw);
  }
}

std::uint64_t SceneGeometry::triangles(const Sight& sight) const {
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < batches_.size(); ++i)
    if (const Batch& batch = batches_[i]; (batch.layers & sight.layers) != 0)
      add_draws(piece_of(batch, i), sight, draws);
  std::uint64_t triangles = 0;
  for (const Draw& draw : draws) triangles += std::uint64_t{draw.level.count / 3} * draw.of.count;
  return triangles;
}

SceneGeometry::Piece SceneGeometry::piece_of(const Batch& batch, std::size_t index) {
  return {batch.material, batch.look, index, batch.first_slot, batch.count};
}

void SceneGeometry::draw(VkCommandBuffer commands, const Draw& draw) const {
  vkCmdDrawIndexed(commands, draw.level.count, draw.of.count, draw.level.first,
                   places_[batches_[draw.of.batch].mesh].first_vertex, draw.of.first_slot);
}

std::vector<SceneGeometry::Draw> SceneGeometry::opaque(const Sight& sight) const {
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < batches_.size(); ++i)
    if (const Batch& batch = batches_[i]; !is_blended(batch.look) && (batch.layers & sight.layers) != 0)
      add_draws(piece_of(batch, i), sight, draws);
  std::ranges::stable_sort(draws, {}, &Draw::distance);
  return draws;
}

void SceneGeometry::draw_plain(VkCommandBuffer commands, const Sight& sight) const {
  bind(commands);
  for (std::size_t i = 0; i < batches_.size(); ++i)
    if (const Batch& batch = batches_[i]; !batch.material && (batch.layers & sight.layers) != 0)
      draw(commands, piece_of(batch, i), sight);
}

void SceneGeometry::draw_tool(VkCommandBuffer commands, std::uint32_t layers) const {
  bind(commands);
  for (std::size_t i = 0; i < batches_.size(); ++i) {
    const Batch& batch = batches_[i];
    if (batch.tool && (batch.layers & layers) != 0)
      draw(commands, {0.0F, places_[batch.mesh].whole, {batch.material, batch.look, i, batch.first_slot, 1}});
  }
}

void SceneGeometry::draw(VkCommandBuffer commands, const Piece& piece, const Sight& sight) const {
  std::vector<Draw> draws;
  add_draws(piece, sight, draws);
  for (const Draw& each : draws) draw(commands, each);
}

std::vector<SceneGeometry::Piece> SceneGeometry::detailed(std::uint32_t layers) const {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < batches_.size(); ++i) {
    const Batch& batch = batches_[i];
    if (batch.material && !is_blended(batch.look) && (batch.layers & layers) != 0)
      pieces.push_back(piece_of(batch, i));
  }
  return pieces;
}

std::vector<SceneGeometry::Piece> SceneGeometry::blended(const glm::vec3& eye, std::uint32_t layers) const {
  std::vector<std::pair<float, Piece>> found;
  for (std::size_t i = 0; i < batches_.size(); ++i) {
    const Batch& batch = batches_[i];
    if (!batch.material || !is_blended(batch.look) || (batch.layers & layers) == 0) continue;
    for (std::uint32_t slot = batch.first_slot; slot < batch.first_slot + batch.count; ++slot) {
      const float away = distance_to(slots_[slot].box, slots_[slot].X_WM, eye);
      found.push_back({away, {batch.material, batch.look, i, slot, 1}});
    }
  }
  std::ranges::stable_sort(found, std::greater{}, &std::pair<float, Piece>::first);
  std::vector<Piece> pieces;
  for (const auto& [away, piece] : found) pieces.push_back(piece);
  return pieces;
}

std::vector<SceneGeometry::Piece> SceneGeometry::masked_casters(Casters which, std::uint32_t layers) const {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < batches_.size(); ++i) {
    const Batch& batch = batches_[i];
    if (is_masked(batch.look) && is_among(batch, which) && (batch.layers & layers) != 0)
      pieces.push_back({batch.material, batch.look, i, batch.first_slot, batch.casters});
  }
  return pieces;
}

}  // namespace fulcrum::render
