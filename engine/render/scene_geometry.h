#pragma once
// Meshes and instances on the device.

#include <optional>
#include <span>
#include <vector>

#include "engine/render/light_fit.h"
#include "engine/vulkan/buffer.h"
#include "shaders/shared/instance.h"

namespace fulcrum::render {

class SceneGeometry {
public:
  // A valid description with at least one instance. Throws vulkan::Failure.
  SceneGeometry(vulkan::Device& device, const VisualDesc& desc);

  std::size_t movable_count() const { return movable_slots_.size(); }

  // Writes the poses of the movable instances, while no frame is in flight. True when something that throws
  // a shadow has moved.
  bool place(std::span<const glm::mat4> X_WM);

  // What throws shadows is from now on what a camera of these layers sees. True when that is other than
  // before.
  bool see(std::uint32_t layers);

  // Boxes around what is seen and throws a shadow, in the world, as placed.
  std::vector<Bounds> casters() const;

  VkBuffer instances() const { return instances_.get(); }

  enum class Which {
    plain,  // without detailed materials
    tool    // each mesh that follows the tool, once: for a pipeline that brings its own pose
  };
  // Binds the buffers and draws what a camera of these layers sees; pipeline and descriptor sets are bound by
  // the caller.
  void draw(VkCommandBuffer commands, Which which, std::uint32_t layers) const;

  // What throws a shadow: all of it, what never moves, or what may.
  enum class Casters { all, standing, moving };
  // Without those that have holes.
  void draw_casters(VkCommandBuffer commands, Casters which) const;

  // Instances of one mesh and one detailed material.
  struct Piece {
    std::size_t material = 0;  // of the description
    std::uint32_t look = 0;    // of that (look.h)
    std::size_t batch = 0;
    std::uint32_t first_slot = 0;
    std::uint32_t count = 0;
  };
  // Those that are not blended, by their looks; those that are, one by one, the farthest from the eye first;
  // those that throw a shadow with holes in it.
  std::vector<Piece> detailed(std::uint32_t layers) const;
  std::vector<Piece> blended(const glm::vec3& eye, std::uint32_t layers) const;
  std::vector<Piece> masked_casters(Casters which) const;
  void bind(VkCommandBuffer commands) const;
  void draw(VkCommandBuffer commands, const Piece& piece) const;

private:
  // All instances of one mesh that are plain, or of one detailed material, and that all stand or may all
  // move, lie side by side, those that throw a shadow first: one draw each.
  struct Batch {
    std::size_t mesh = 0;
    std::optional<std::size_t> material;  // none: plain ones, each with its own
    std::uint32_t look = 0;               // of the material
    bool movable = false;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::int32_t first_vertex = 0;
    std::uint32_t first_slot = 0;
    std::uint32_t count = 0;
    std::uint32_t casters = 0;
    bool tool = false;
    std::uint32_t layers = 0;
  };

  // A place in the instance buffer.
  struct Slot {
    Bounds mesh_bounds;
    glm::mat4 X_WM{1.0F};
    bool casts = false;
    std::uint32_t layers = 0;
  };

  struct Place {
    std::uint32_t first_index = 0;
    std::int32_t first_vertex = 0;
  };

  static std::uint32_t count_of(const Batch& batch, Which which);
  static bool is_among(const Batch& batch, Casters which);
  std::vector<Place> upload_meshes(vulkan::Device& device, const VisualDesc& desc);
  void sort_instances(const VisualDesc& desc, const std::vector<Place>& places);
  gpu::InstanceData* data() { return reinterpret_cast<gpu::InstanceData*>(instances_.mapped()); }

  vulkan::Buffer vertices_;
  vulkan::Buffer uv_;  // of the meshes that come first; empty where no material is detailed
  vulkan::Buffer indices_;
  vulkan::Buffer instances_;
  std::vector<Batch> batches_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> movable_slots_;
  std::uint32_t seen_ = 1;  // layers
};

}  // namespace fulcrum::render
