#include "haptics/bake/patches.h"

#include <algorithm>

#include "haptics/bake/sentence.h"

namespace fulcrum {
namespace {

struct Links {
  std::array<std::uint32_t, 3> there{kNoIndex, kNoIndex, kNoIndex};
  std::array<bool, 3> agree{};
};

double area_of(const TriangleMesh& mesh, std::uint32_t t) {
  const Triangle& corner = mesh.triangles[t];
  const Vec3& a = mesh.vertices[corner[0]];
  return 0.5 * (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a).norm();
}

}  // namespace

void turn(Triangle& triangle) {
  std::swap(triangle[1], triangle[2]);
}

Result<std::vector<Patch>> cut_into_patches(TriangleMesh& mesh) {
  std::vector<Links> links(mesh.triangles.size());
  std::vector<bool> open(mesh.triangles.size()), joined(mesh.triangles.size());
  EdgeFans(mesh.triangles).for_each([&](std::span<const HalfEdge> fan) {
    if (fan.size() == 1) open[fan[0].place / 3] = true;
    if (fan.size() > 2)
      for (const HalfEdge& edge : fan) joined[edge.place / 3] = true;
    if (fan.size() != 2) return;
    for (std::size_t i = 0; i < 2; ++i) {
      links[fan[i].place / 3].there[fan[i].place % 3] = fan[1 - i].place / 3;
      links[fan[i].place / 3].agree[fan[i].place % 3] = fan[0].forward != fan[1].forward;
    }
  });

  std::vector<Patch> patches;
  std::vector<bool> known(mesh.triangles.size()), against(mesh.triangles.size());
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (known[first]) continue;
    known[first] = true;
    Patch patch{{first}, 0, false, false};
    for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
      const std::uint32_t t = patch.triangles[i];
      patch.open = patch.open || open[t];
      patch.joined = patch.joined || joined[t];
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t there = links[t].there[e];
        if (there == kNoIndex) continue;
        const bool wanted = links[t].agree[e] ? against[t] : !against[t];
        if (!known[there]) {
          known[there] = true;
          against[there] = wanted;
          patch.triangles.push_back(there);
        } else if (against[there] != wanted) {
          return Error{"The surface around " + spell(mesh.vertices[mesh.triangles[there][e]]) +
                       " has one side only, as a Moebius strip has: give it thickness."};
        }
      }
    }
    std::sort(patch.triangles.begin(), patch.triangles.end());
    double with = 0.0, opposed = 0.0;
    for (const std::uint32_t t : patch.triangles) (against[t] ? opposed : with) += area_of(mesh, t);
    const bool minority = with >= opposed;  // those against the first triangle are the fewer
    for (const std::uint32_t t : patch.triangles) {
      if (against[t] != minority) continue;
      turn(mesh.triangles[t]);
      ++patch.turned;
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace fulcrum
