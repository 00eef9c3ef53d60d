#include "engine/render/levels_of_detail.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <span>
#include <thread>
#include <unordered_map>

#include "engine/render/edge_collapse.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::render {
namespace {

constexpr std::size_t kPieceTriangles = 16384;  // at the most
constexpr double kLargeTurn = 1.0;              // between two normals, as the distance of their ends
constexpr double kLargeTint = 0.6;              // between two colours

using Triangles = std::span<std::uint32_t>;  // numbers of triangles

// Halves until each is small enough, across the longest side of where they lie.
void split(Triangles triangles, const std::vector<glm::vec3>& middles, std::vector<Triangles>& pieces) {
  if (triangles.size() <= kPieceTriangles) {
    pieces.push_back(triangles);
    return;
  }
  glm::vec3 low = middles[triangles.front()], high = low;
  for (const std::uint32_t t : triangles) low = glm::min(low, middles[t]), high = glm::max(high, middles[t]);
  const glm::vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = triangles.size() / 2;
  std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis]
                                                                 : a < b;
                   });
  split(triangles.first(half), middles, pieces);
  split(triangles.subspan(half), middles, pieces);
}

SeenAt seen_at(const Mesh& mesh, std::size_t vertex) {
  SeenAt seen{};
  for (int axis = 0; axis < 3; ++axis) {
    seen[static_cast<std::size_t>(axis)] = static_cast<double>(mesh.normals[vertex][axis]) / kLargeTurn;
    if (!mesh.colours.empty())
      seen[static_cast<std::size_t>(axis) + 3] = static_cast<double>(mesh.colours[vertex][axis]) / kLargeTint;
  }
  return seen;
}

// 1/m: how fast each coordinate changes along the surface, root mean square. 0: it is the same everywhere, or
// not read.
UvAt mean_gradients(const Mesh& mesh, const UvSets& read) {
  UvAt sums{};
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.indices[i + k]; };
    const glm::dvec3 origin(mesh.positions[at(0)]);
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[at(1)]) - origin,
                     e2 = glm::dvec3(mesh.positions[at(2)]) - origin, across = glm::cross(e1, e2);
    const double square = glm::dot(across, across);
    if (!(square > 0.0)) continue;
    area += std::sqrt(square);
    const glm::dvec4 first(mesh.uv[at(0)]);
    const glm::dvec4 d1 = glm::dvec4(mesh.uv[at(1)]) - first, d2 = glm::dvec4(mesh.uv[at(2)]) - first;
    for (std::size_t k = 0; k < kUv; ++k) {
      const auto axis = static_cast<int>(k);
      const glm::dvec3 change = d1[axis] * e2 - d2[axis] * e1;  // a gradient times twice the area, turned
      if (read[k / 2]) sums[k] += glm::dot(change, change) / std::sqrt(square);
    }
  }
  for (double& sum : sums) sum = area > 0.0 ? std::sqrt(sum / area) : 0.0;
  return sums;
}

// (n) m, as SlideQuadric has them; none, where no texture is laid on.
std::vector<UvAt> places_in_textures(const Mesh& mesh, const UvSets& read) {
  std::vector<UvAt> places;
  if (mesh.uv.empty() || (!read[0] && !read[1])) return places;
  const UvAt gradients = mean_gradients(mesh, read);
  for (const glm::vec4& uv : mesh.uv) {
    UvAt& place = places.emplace_back();
    for (std::size_t k = 0; k < kUv; ++k)
      if (gradients[k] > 0.0) place[k] = static_cast<double>(uv[static_cast<int>(k)]) / gradients[k];
  }
  return places;
}

// The levels of one piece, by numbers of the mesh's vertices.
struct PieceLevels {
  Bounds bounds;
  std::vector<std::vector<std::uint32_t>> indices;
  std::vector<float> errors;
};

// Whether more than one piece has a vertex.
std::vector<bool> shared_by(const std::vector<Triangles>& pieces, const Mesh& mesh) {
  constexpr std::size_t kNoPiece = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(mesh.positions.size(), kNoPiece);
  std::vector<bool> shared(mesh.positions.size(), false);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    for (const std::uint32_t t : pieces[piece])
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh.indices[3 * std::size_t{t} + i];
        if (first[vertex] == kNoPiece) first[vertex] = piece;
        shared[vertex] = shared[vertex] || first[vertex] != piece;
      }
  return shared;
}

PieceLevels levels_of(const Mesh& mesh, const std::vector<UvAt>& uv, const std::vector<bool>& shared,
                      Triangles triangles) {
  std::ranges::sort(triangles);
  PieceLevels levels;
  levels.indices.emplace_back();
  levels.errors.push_back(0.0F);
  Patch patch;
  std::vector<std::uint32_t> vertices;  // of the mesh, by the patch's numbers
  std::unordered_map<std::uint32_t, std::uint32_t> place;
  for (const std::uint32_t t : triangles) {
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = mesh.indices[3 * std::size_t{t} + i];
      const auto [found, added] = place.try_emplace(vertex, static_cast<std::uint32_t>(vertices.size()));
      if (added) {
        vertices.push_back(vertex);
        const glm::vec3& at = mesh.positions[vertex];
        patch.positions.push_back(glm::dvec3(at - mesh.positions[vertices.front()]));
        patch.seen.push_back(seen_at(mesh, vertex));
        patch.stays.push_back(shared[vertex]);
        if (!uv.empty()) patch.uv.push_back(uv[vertex]);
        levels.bounds = vertices.size() == 1 ? Bounds{at, at} : united(levels.bounds, {at, at});
      }
      corners[i] = found->second;
      levels.indices.front().push_back(vertex);
    }
    patch.triangles.push_back(corners);
  }
  for (const CoarserPatch& coarser : collapse_edges(std::move(patch))) {
    levels.indices.emplace_back();
    for (const Corners& t : coarser.triangles)
      for (const std::uint32_t corner : t) levels.indices.back().push_back(vertices[corner]);
    levels.errors.push_back(static_cast<float>(coarser.error));
  }
  return levels;
}

}  // namespace

LevelsOfDetail levels_of_detail(const Mesh& mesh, const UvSets& read) {
  std::vector<glm::vec3> middles(mesh.indices.size() / 3);
  for (std::size_t t = 0; t < middles.size(); ++t)
    middles[t] = (mesh.positions[mesh.indices[3 * t]] + mesh.positions[mesh.indices[3 * t + 1]] +
                  mesh.positions[mesh.indices[3 * t + 2]]) /
                 3.0F;
  std::vector<std::uint32_t> triangles(middles.size());
  std::iota(triangles.begin(), triangles.end(), 0U);
  std::vector<Triangles> pieces;
  split(triangles, middles, pieces);
  const std::vector<UvAt> uv = places_in_textures(mesh, read);
  const std::vector<bool> shared = shared_by(pieces, mesh);
  std::vector<PieceLevels> made(pieces.size());
  std::atomic<std::size_t> next{0};
  {
    const auto work = [&] {
      for (std::size_t piece = next++; piece < pieces.size(); piece = next++)
        made[piece] = levels_of(mesh, uv, shared, pieces[piece]);
    };
    std::vector<std::jthread> others;
    const std::size_t workers = std::min<std::size_t>(std::thread::hardware_concurrency(), pieces.size());
    for (std::size_t i = 1; i < workers; ++i) others.emplace_back(work);
    work();
  }
  LevelsOfDetail all;
  const auto add = [&all](LevelsOfDetail::Piece& piece, const PieceLevels& levels, std::size_t level) {
    const std::vector<std::uint32_t>& indices = levels.indices[level];
    piece.levels.push_back({static_cast<std::uint32_t>(all.indices.size()),
                            static_cast<std::uint32_t>(indices.size()), levels.errors[level]});
    all.indices.insert(all.indices.end(), indices.begin(), indices.end());
  };
  for (const PieceLevels& levels : made) {
    LevelsOfDetail::Piece& piece = all.pieces.emplace_back();
    piece.bounds = levels.bounds;
    add(piece, levels, 0);
  }
  for (std::size_t i = 0; i < made.size(); ++i)
    for (std::size_t level = 1; level < made[i].indices.size(); ++level) add(all.pieces[i], made[i], level);
  return all;
}

}  // namespace fulcrum::render
