#include "engine/render/ghost_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "engine/render/bounds.h"

namespace fulcrum::render {
namespace {

// One number for all vertices in one place: a mesh has several where its normals or colours jump, and where
// a program that wrote it rounded, they lie a little apart.
std::vector<std::uint32_t> weld(const Mesh& mesh) {
  const Bounds bounds = bounds_of(mesh.positions);
  const float width_m = 1e-5F * glm::distance(bounds.low, bounds.high);
  // Swept along a direction that no face of an aligned model is perpendicular to, so that few are level.
  constexpr glm::vec3 kSweep{0.53F, 0.67F, 0.52F};
  std::vector<float> along;
  for (const glm::vec3& position : mesh.positions) along.push_back(glm::dot(position, kSweep));
  std::vector<std::uint32_t> order(along.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return std::tie(along[a], a) < std::tie(along[b], b); });
  std::vector<std::uint32_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t self = order[i];
    place[self] = self;
    for (std::size_t j = i; j-- > 0 && along[self] - along[order[j]] <= width_m;) {
      if (glm::distance(mesh.positions[self], mesh.positions[order[j]]) <= width_m) {
        place[self] = place[order[j]];
        break;
      }
    }
  }
  return place;
}

// One side of a triangle.
struct Side {
  std::uint32_t low = 0;  // welded vertices
  std::uint32_t high = 0;
  std::uint32_t face = 0;

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

}  // namespace

GhostEdges::GhostEdges(const VisualDesc& desc, const Ghost& look) {
  std::vector<std::size_t> meshes;
  for (const Instance& instance : desc.instances) {
    if (instance.movable && instance.follows == 0 &&
        std::find(meshes.begin(), meshes.end(), instance.mesh) == meshes.end()) {
      meshes.push_back(instance.mesh);
      add(desc.meshes[instance.mesh], look.crease_rad);
    }
  }
  towards_eye_.resize(faces_.size());
}

void GhostEdges::add(const Mesh& mesh, float crease_rad) {
  const std::vector<std::uint32_t> place = weld(mesh);
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::array<std::uint32_t, 3> at = {place[mesh.indices[t]], place[mesh.indices[t + 1]],
                                             place[mesh.indices[t + 2]]};
    const glm::vec3 p = mesh.positions[at[0]];
    const glm::vec3 area = glm::cross(mesh.positions[at[1]] - p, mesh.positions[at[2]] - p);
    if (!(glm::length(area) > 0.0F))
      continue;  // no triangle, but a line or a point: its neighbours meet without it
    const glm::vec3 normal = glm::normalize(area);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(at[i], at[(i + 1) % 3]);
      sides.push_back({low, high, static_cast<std::uint32_t>(faces_.size())});
    }
    faces_.push_back({normal, glm::dot(normal, p)});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });

  const float smooth = std::cos(crease_rad);
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    for (next = i + 1; next < sides.size() && sides[next].same_edge(sides[i]); ++next) {
    }
    const std::size_t met = next - i;
    Edge edge{mesh.positions[sides[i].low], mesh.positions[sides[i].high], sides[i].face,
              sides[next - 1].face, false};
    const bool crease = met > 2 || glm::dot(faces_[edge.left].normal, faces_[edge.right].normal) < smooth;
    edge.sharp = met == 1 || crease;
    boundaries_ += met == 1 ? 1 : 0;
    creases_ += crease ? 1 : 0;
    edges_.push_back(edge);
  }
}

std::size_t GhostEdges::choose(const glm::vec3& p_GE, gpu::GhostLine* to) {
  for (std::size_t i = 0; i < faces_.size(); ++i)
    towards_eye_[i] = glm::dot(faces_[i].normal, p_GE) > faces_[i].offset ? 1 : 0;
  std::size_t count = 0;
  for (const Edge& edge : edges_) {
    const bool left = towards_eye_[edge.left] != 0;
    const bool right = towards_eye_[edge.right] != 0;
    const bool boundary = edge.left == edge.right;
    if (left != right || (edge.sharp && (left || boundary)))
      to[count++] = {glm::vec4(edge.from, 1.0F), glm::vec4(edge.to, 1.0F)};
  }
  return count;
}

}  // namespace fulcrum::render
