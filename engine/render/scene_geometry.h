#pragma once
// Meshes and instances on the device.

#include <optional>
#include <span>
#include <vector>

#include "engine/render/light_fit.h"
#include "engine/render/oriented_box.h"
#include "engine/render/sight.h"
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

  // That are drawn for it.
  std::uint64_t triangles(const Sight& sight) const;

  // Boxes around what a camera of these layers sees and throws a shadow, in the world, as placed.
  std::vector<Bounds> casters(std::uint32_t layers) const;
  // Whether that is the same for both.
  bool casts_alike(std::uint32_t layers, std::uint32_t others) const;

  VkBuffer instances() const { return instances_.get(); }

  // Both bind the buffers; pipeline and descriptor sets are bound by the caller. Draws what is
  // seen of all that has no detailed material.
  void draw_plain(VkCommandBuffer commands, const Sight& sight) const;
  // Each mesh that follows the tool, once and whole: for a pipeline that brings its own pose.
  void draw_tool(VkCommandBuffer commands, std::uint32_t layers) const;

  // What throws a shadow: all of it, what never moves, or what may.
  enum class Casters { all, standing, moving };
  // Without those that have holes. light: which sees all that it throws the shadows of, of its layers.
  void draw_casters(VkCommandBuffer commands, Casters which, const Sight& light) const;

  // Instances of one mesh that are plain, or of one detailed material.
  struct Piece {
    std::optional<std::size_t> material;  // of the description; none: plain ones, each with its own
    std::uint32_t look = 0;               // of that (look.h)
    std::size_t batch = 0;
    std::uint32_t first_slot = 0;
    std::uint32_t count = 0;
  };
  // Triangles of all instances of a piece, or of a part of its mesh.
  struct Draw {
    float distance = 0.0F;  // m, to the nearest instance
    LevelsOfDetail::Level level;
    Piece of;
  };
  // What is seen and not blended, the nearest first, whatever it is made of: what it hides need not be
  // shaded. Of two surfaces at the same depth the first drawn is seen: which one may change with the eye.
  std::vector<Draw> opaque(const Sight& sight) const;
  // Detailed ones: those that are not blended; those that are, one by one, the farthest from the eye first;
  // those that throw a shadow with holes in it.
  std::vector<Piece> detailed(std::uint32_t layers) const;
  std::vector<Piece> blended(const glm::vec3& eye, std::uint32_t layers) const;
  std::vector<Piece> masked_casters(Casters which, std::uint32_t layers) const;
  void bind(VkCommandBuffer commands) const;
  void draw(VkCommandBuffer commands, const Piece& piece, const Sight& sight) const;
  void draw(VkCommandBuffer commands, const Draw& draw) const;

private:
  // All instances of one mesh that are plain, or of one detailed material, and that all stand or may all
  // move, lie side by side, those that throw a shadow first: one draw each.
  struct Batch {
    std::size_t mesh = 0;
    std::optional<std::size_t> material;  // none: plain ones, each with its own
    std::uint32_t look = 0;               // of the material
    bool movable = false;
    std::uint32_t first_slot = 0;
    std::uint32_t count = 0;
    std::uint32_t casters = 0;
    bool tool = false;
    std::uint32_t layers = 0;
  };

  // A place in the instance buffer.
  struct Slot {
    Bounds mesh_bounds;
    OrientedBox box;  // around what is blended
    glm::mat4 X_WM{1.0F};
    bool casts = false;
    std::uint32_t layers = 0;
  };

  // Where a mesh is in the buffers.
  struct Place {
    LevelsOfDetail::Level whole;
    std::vector<LevelsOfDetail::Piece> pieces;  // at least one
    std::int32_t first_vertex = 0;
  };

  static Place place_of(const Mesh& mesh, std::size_t first_index, std::size_t first_vertex);
  static bool is_among(const Batch& batch, Casters which);
  void upload_meshes(vulkan::Device& device, const VisualDesc& desc);
  void sort_instances(const VisualDesc& desc);
  // What is seen of it, each part as coarse as may be.
  void add_draws(const Piece& piece, const Sight& sight, std::vector<Draw>& draws) const;
  static Piece piece_of(const Batch& batch, std::size_t index);
  gpu::InstanceData* data() { return reinterpret_cast<gpu::InstanceData*>(instances_.mapped()); }

  vulkan::Buffer vertices_;
  vulkan::Buffer uv_;  // of the meshes that come first; empty where no look reads them
  vulkan::Buffer indices_;
  vulkan::Buffer instances_;
  std::vector<Place> places_;  // by mesh
  std::vector<Batch> batches_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> movable_slots_;
};

}  // namespace fulcrum::render
