#include "tests/parts/exported.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "haptics/math/split_mix.h"

namespace fulcrum::parts {
namespace {

Vec3 in_single(const Vec3& p) {
  return p.cast<float>().cast<double>();
}

}  // namespace

TriangleMesh with_t_junctions(const TriangleMesh& mesh, double share, unsigned most, bool slivers,
                              std::uint64_t seed) {
  SplitMix random(seed);
  TriangleMesh cut{mesh.vertices, {}};
  for (Vec3& p : cut.vertices) p = in_single(p);
  // The places of an edge, from its lower vertex to its higher, and the triangle that has them.
  struct Cut {
    std::size_t triangle = 0;
    std::vector<std::uint32_t> places;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Cut> cuts;
  std::vector<bool> is_cut(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (unsigned e = 0; e < 3; ++e) {
      const std::uint32_t a = mesh.triangles[t][e], b = mesh.triangles[t][(e + 1) % 3];
      const auto key = std::minmax(a, b);
      if (is_cut[t] || cuts.contains(key) || random.uniform() > share) continue;
      is_cut[t] = true;
      Cut& edge = cuts[key];
      edge.triangle = t;
      const auto n = 1 + static_cast<unsigned>(most * random.uniform() * 0.999);
      std::vector<double> at(n);
      for (double& s : at) s = 0.05 + 0.9 * random.uniform();
      std::sort(at.begin(), at.end());
      for (const double s : at) {
        edge.places.push_back(static_cast<std::uint32_t>(cut.vertices.size()));
        cut.vertices.push_back(
            in_single(mesh.vertices[key.first] + s * (mesh.vertices[key.second] - mesh.vertices[key.first])));
      }
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    bool whole = true;
    for (unsigned e = 0; e < 3; ++e) {
      const std::uint32_t a = corners[e], b = corners[(e + 1) % 3], c = corners[(e + 2) % 3];
      const auto found = cuts.find(std::minmax(a, b));
      if (found == cuts.end()) continue;
      std::vector<std::uint32_t> way = found->second.places;
      if (a > b) std::reverse(way.begin(), way.end());
      way.insert(way.begin(), a);
      way.push_back(b);
      if (found->second.triangle == t) {
        whole = false;
        for (std::size_t i = 0; i + 1 < way.size(); ++i) cut.triangles.push_back({way[i], way[i + 1], c});
      } else if (slivers) {
        for (std::size_t i = 1; i + 1 < way.size(); ++i)
          cut.triangles.push_back({way[i + 1], way[0], way[i]});
      }
    }
    if (whole) cut.triangles.push_back(corners);
  }
  return cut;
}

TriangleMesh face_by_face(const TriangleMesh& mesh, double noise, std::uint64_t seed) {
  SplitMix random(seed);
  TriangleMesh apart;
  for (const Triangle& corners : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t v : corners)
      apart.vertices.push_back(
          in_single(mesh.vertices[v] + noise * Vec3(2 * random.uniform() - 1, 2 * random.uniform() - 1,
                                                    2 * random.uniform() - 1)));
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

TriangleMesh repeating(TriangleMesh mesh, double share, std::uint64_t seed) {
  SplitMix random(seed);
  const std::size_t n = mesh.triangles.size();
  for (std::size_t t = 0; t < n; ++t)
    if (random.uniform() < share) mesh.triangles.push_back(mesh.triangles[t]);
  return mesh;
}

TriangleMesh turned(TriangleMesh mesh, double share, std::uint64_t seed) {
  SplitMix random(seed);
  for (Triangle& corners : mesh.triangles)
    if (random.uniform() < share) std::swap(corners[1], corners[2]);
  return mesh;
}

}  // namespace fulcrum::parts
