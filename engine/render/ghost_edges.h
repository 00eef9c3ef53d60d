#pragma once
// The edges of a mesh that a line drawing of it may show: creases and boundaries always, any other edge where
// it is a silhouette, between a triangle that faces the eye and one that does not.

#include <vector>

#include "engine/render/visual_desc.h"
#include "shaders/shared/ghost.h"

namespace fulcrum::render {

class GhostEdges {
public:
  // Of all that follows the tool in a valid description with a ghost of that look, together: they share one
  // pose.
  GhostEdges(const VisualDesc& desc, const Ghost& look);

  std::size_t size() const { return edges_.size(); }
  std::size_t creases() const { return creases_; }
  std::size_t boundaries() const { return boundaries_; }

  // The lines that an eye at p_GE (m, the ghost's frame) may see, written to `to`, which has room for
  // size(); returns how many. What hides what is not asked here. On the processor, in one pass over faces
  // and edges: a software rasteriser takes longer to look at one vertex than this takes for fifty edges.
  std::size_t choose(const glm::vec3& p_GE, gpu::GhostLine* to);

private:
  struct Face {
    glm::vec3 normal;  // unit, outwards
    float offset = 0;  // m, of its plane along the normal
  };
  struct Edge {
    glm::vec3 from;  // m
    glm::vec3 to;
    std::uint32_t left = 0;  // indices of faces; of a boundary the same twice
    std::uint32_t right = 0;
    bool sharp = false;
  };

  void add(const Mesh& mesh, float crease_rad);

  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<std::uint8_t> towards_eye_;  // of each face, while choosing
  std::size_t creases_ = 0;
  std::size_t boundaries_ = 0;
};

}  // namespace fulcrum::render
