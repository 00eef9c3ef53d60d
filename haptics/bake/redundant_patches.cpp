#include "haptics/bake/redundant_patches.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fulcrum {
namespace {

// An edge where more than two triangles meet: how often each patch runs along it, against it counting less.
using Seam = std::map<std::uint32_t, int>;

int surplus(const Seam& seam) {
  int sum = 0;
  for (const auto& [patch, runs] : seam) sum += runs;
  return std::abs(sum);
}

}  // namespace

std::vector<bool> redundant_patches(const TriangleMesh& mesh, const std::vector<Patch>& patches,
                                    const std::vector<PatchVisibility>& visibility) {
  std::vector<std::uint32_t> patch_of(mesh.triangles.size()), order;
  for (std::uint32_t i = 0; i < patches.size(); ++i) {
    for (const std::uint32_t t : patches[i].triangles) patch_of[t] = i;
    if (patches[i].joined) order.push_back(i);
  }
  std::vector<Seam> seams;
  std::vector<std::vector<std::size_t>> seams_of(patches.size());
  EdgeFans(mesh.triangles).for_each([&](std::span<const HalfEdge> fan) {
    if (fan.size() < 3) return;
    Seam seam;
    for (const HalfEdge& edge : fan) seam[patch_of[edge.place / 3]] += edge.forward ? 1 : -1;
    for (const auto& [patch, runs] : seam) seams_of[patch].push_back(seams.size());
    seams.push_back(std::move(seam));
  });

  const auto decided = [&visibility](std::uint32_t i) {
    return std::abs(visibility[i].front - visibility[i].back);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t l, std::uint32_t r) { return decided(l) < decided(r); });
  std::vector<bool> redundant(patches.size());
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::uint32_t i : order) {
      if (redundant[i]) continue;
      int better = 0, worse = 0;
      for (const std::size_t s : seams_of[i]) {
        Seam without = seams[s];
        without.erase(i);
        const int change = surplus(without) - surplus(seams[s]);
        better += change < 0 ? 1 : 0;
        worse += change > 0 ? 1 : 0;
      }
      if (better == 0 || worse > 0) continue;
      for (const std::size_t s : seams_of[i]) seams[s].erase(i);
      redundant[i] = changed = true;
      break;
    }
  }
  return redundant;
}

}  // namespace fulcrum
