#include "engine/render/scene_geometry.h"

#include <algorithm>
#include <numeric>
#include <utility>

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

std::array<std::uint8_t, 4> to_bytes(const glm::vec3& colour) {
  const glm::vec3 scaled = 255.0F * glm::clamp(colour, 0.0F, 1.0F) + 0.5F;
  return {static_cast<std::uint8_t>(scaled.r), static_cast<std::uint8_t>(scaled.g),
          static_cast<std::uint8_t>(scaled.b), 255};
}

gpu::InstanceData to_gpu(const Instance& instance, const Material& material) {
  gpu::InstanceData made{};
  write_pose(made, instance.X_WM);
  made.base_colour = glm::vec4(material.base_colour, 1.0F);
  made.surface = {material.metallic, material.roughness, 0.0F, 0.0F};
  return made;
}

}  // namespace

SceneGeometry::SceneGeometry(vulkan::Device& device, const VisualDesc& desc)
    : instances_(device, desc.instances.size() * sizeof(gpu::InstanceData),
                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Place::upload) {
  upload_meshes(device, desc);
  sort_instances(desc);
}

void SceneGeometry::upload_meshes(vulkan::Device& device, const VisualDesc& desc) {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const Mesh& mesh : desc.meshes) {
    batches_.push_back({static_cast<std::uint32_t>(indices.size()),
                        static_cast<std::uint32_t>(mesh.indices.size()),
                        static_cast<std::int32_t>(vertices.size()), 0, 0, 0, false, 0});
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      Vertex vertex{.position = mesh.positions[i], .normal = mesh.normals[i]};
      if (!mesh.colours.empty()) vertex.colour = to_bytes(mesh.colours[i]);
      vertices.push_back(vertex);
    }
    indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
  }
  vertices_ = vulkan::upload(device, std::as_bytes(std::span(vertices)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  indices_ = vulkan::upload(device, std::as_bytes(std::span(indices)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

void SceneGeometry::sort_instances(const VisualDesc& desc) {
  std::vector<std::size_t> order(desc.instances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Instance& left = desc.instances[a];
    const Instance& right = desc.instances[b];
    return left.mesh != right.mesh ? left.mesh < right.mesh : left.casts_shadow && !right.casts_shadow;
  });
  std::vector<Bounds> mesh_bounds;
  for (const Mesh& mesh : desc.meshes) mesh_bounds.push_back(bounds_of(mesh));
  std::vector<std::uint32_t> slot_of(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto slot = static_cast<std::uint32_t>(i);
    const Instance& instance = desc.instances[order[i]];
    slot_of[order[i]] = slot;
    slots_.push_back({mesh_bounds[instance.mesh], instance.X_WM, instance.casts_shadow, instance.layers});
    data()[slot] = to_gpu(instance, desc.materials[instance.material]);
    Batch& batch = batches_[instance.mesh];
    batch.first_slot = batch.count == 0 ? slot : batch.first_slot;
    batch.count += 1;
    batch.casters += instance.casts_shadow ? 1 : 0;
    batch.tool = batch.tool || (instance.movable && instance.follows == 0);
    batch.layers = instance.layers;
  }
  for (std::size_t i = 0; i < order.size(); ++i)
    if (desc.instances[i].movable) movable_slots_.push_back(slot_of[i]);
  std::erase_if(batches_, [](const Batch& batch) { return batch.count == 0; });
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

bool SceneGeometry::see(std::uint32_t layers) {
  return std::exchange(seen_, layers) != layers;
}

std::vector<Bounds> SceneGeometry::casters() const {
  std::vector<Bounds> boxes;
  for (const Slot& slot : slots_)
    if (slot.casts && (slot.layers & seen_) != 0) boxes.push_back(transformed(slot.mesh_bounds, slot.X_WM));
  return boxes;
}

std::uint32_t SceneGeometry::count_of(const Batch& batch, Which which) {
  switch (which) {
    case Which::casters:
      return batch.casters;
    case Which::tool:
      return batch.tool ? 1 : 0;
    default:
      return batch.count;
  }
}

void SceneGeometry::draw(VkCommandBuffer commands, Which which, std::uint32_t layers) const {
  const VkBuffer vertices = vertices_.get();
  const VkDeviceSize offset = 0;
  vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
  vkCmdBindIndexBuffer(commands, indices_.get(), 0, VK_INDEX_TYPE_UINT32);
  for (const Batch& batch : batches_) {
    if ((batch.layers & layers) == 0) continue;
    if (const std::uint32_t count = count_of(batch, which); count > 0) {
      vkCmdDrawIndexed(commands, batch.index_count, count, batch.first_index, batch.first_vertex,
                       batch.first_slot);
    }
  }
}

}  // namespace fulcrum::render
