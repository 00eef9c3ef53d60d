#include "haptics/geometry/feature_mesh.h"

#include <algorithm>
#include <numeric>

namespace fulcrum {
namespace {

constexpr std::uint32_t kLeaf = 4;  // faces
constexpr std::uint32_t kNone = 0xffffffffu;

}  // namespace

FeatureMesh::FeatureMesh(const TriangleMesh& mesh, std::span<const Triangle> neighbours)
    : vertices_(mesh.vertices) {
  std::vector<bool> taken(vertices_.size(), false);
  for (const Triangle& corners : mesh.triangles) {
    const Vec3& a = vertices_[corners[0]];
    Face face{.corners = corners,
              .nhat = (vertices_[corners[1]] - a).cross(vertices_[corners[2]] - a).stableNormalized()};
    for (const std::uint32_t v : corners) face.box.extend(vertices_[v]);
    for (unsigned i = 0; i < 3; ++i) {
      if (taken[corners[i]]) continue;
      taken[corners[i]] = true;
      face.own_corners = static_cast<std::uint8_t>(face.own_corners | 1u << i);
      radius_ = std::max(radius_, vertices_[corners[i]].norm());
    }
    faces_.push_back(face);
  }
  pair_edges(neighbours);

  std::vector<std::vector<std::uint32_t>> around(vertices_.size());
  for (const Edge& edge : edges_) {
    around[edge.from].push_back(edge.to);
    around[edge.to].push_back(edge.from);
  }
  for (const auto& of_vertex : around) {
    around_begin_.push_back(static_cast<std::uint32_t>(around_.size()));
    around_.insert(around_.end(), of_vertex.begin(), of_vertex.end());
  }
  around_begin_.push_back(static_cast<std::uint32_t>(around_.size()));

  order_.resize(faces_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(order_.size()));
}

void FeatureMesh::pair_edges(std::span<const Triangle> neighbours) {
  std::vector<Triangle> known(faces_.size(), {kNone, kNone, kNone});
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    for (unsigned e = 0; e < 3; ++e) {
      const std::uint32_t from = face.corners[e], to = face.corners[(e + 1) % 3];
      if (known[f][e] != kNone) {
        face.edges[e] = known[f][e];
        continue;
      }
      Edge edge{.from = from, .to = to, .opposite = {face.corners[(e + 2) % 3], face.corners[(e + 2) % 3]}};
      edge.flat = true;
      const std::uint32_t other = neighbours[f][e];
      if (other < faces_.size()) {
        const Face& there = faces_[other];
        for (unsigned k = 0; k < 3; ++k) {
          if (there.corners[k] != to || there.corners[(k + 1) % 3] != from) continue;
          edge.opposite[1] = there.corners[(k + 2) % 3];
          known[other][k] = static_cast<std::uint32_t>(edges_.size());
          // How far each side's third corner lies above the other side's face.
          const double above = std::max(face.nhat.dot(vertices_[edge.opposite[1]] - vertices_[from]),
                                        there.nhat.dot(vertices_[edge.opposite[0]] - vertices_[from]));
          const double below = std::min(face.nhat.dot(vertices_[edge.opposite[1]] - vertices_[from]),
                                        there.nhat.dot(vertices_[edge.opposite[0]] - vertices_[from]));
          edge.flat = above < kFlat && below > -kFlat;
          edge.convex = !edge.flat && above <= kFlat;
        }
      }
      face.edges[e] = static_cast<std::uint32_t>(edges_.size());
      face.own_edges = static_cast<std::uint8_t>(face.own_edges | 1u << e);
      edges_.push_back(edge);
    }
  }
}

void FeatureMesh::split(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Box3 box, middles;
  const auto middle = [this](std::uint32_t f) {
    const Triangle& c = faces_[f].corners;
    return Vec3((vertices_[c[0]] + vertices_[c[1]] + vertices_[c[2]]) / 3);
  };
  const auto begin = order_.begin() + first, end = begin + count;
  for (auto f = begin; f != end; ++f) {
    for (const std::uint32_t v : faces_[*f].corners) box.extend(vertices_[v]);
    middles.extend(middle(*f));
  }
  nodes_[node].box = box;
  nodes_[node].centre = box.center();
  nodes_[node].radius = 0.5 * box.diagonal().norm();
  if (count <= kLeaf) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end, [&](std::uint32_t l, std::uint32_t r) {
    const double a = middle(l)[axis], b = middle(r)[axis];
    return a < b || (a == b && l < r);
  });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = children;
  nodes_.resize(nodes_.size() + 2);
  split(children, first, half);
  split(children + 1, first + half, count - half);
}

std::size_t FeatureMesh::bytes() const {
  return vertices_.size() * sizeof(Vec3) + edges_.size() * sizeof(Edge) + faces_.size() * sizeof(Face) +
         nodes_.size() * sizeof(Node) +
         (order_.size() + around_.size() + around_begin_.size()) * sizeof(std::uint32_t);
}

}  // namespace fulcrum
