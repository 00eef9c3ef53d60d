#include "haptics/bake/containment.h"

#include <numbers>

namespace fulcrum {
namespace {

constexpr int kDeepest = 6;  // leaves of 1/64 of the solid's extent

Vec3 child_centre(const Vec3& centre, double half_edge, std::uint32_t octant) {
  const auto side = [&](std::uint32_t bit) {
    return (octant >> bit & 1u) != 0 ? 0.5 * half_edge : -0.5 * half_edge;
  };
  return centre + Vec3(side(0), side(1), side(2));
}

}  // namespace

Containment::Containment(const Box3& bounds, std::span<const Candidate> all, const Distance& distance)
    : centre_(bounds.center()), half_edge_(0.5 * bounds.sizes().maxCoeff() * (1.0 + 1e-6)), cells_(1) {
  divide(0, centre_, half_edge_, all, 0, distance);
}

void Containment::divide(std::uint32_t cell, const Vec3& centre, double half_edge,
                         std::span<const Candidate> parent, int depth, const Distance& distance) {
  const double radius = std::numbers::sqrt3 * half_edge * (1.0 + 1e-6);
  std::vector<Candidate> list;
  std::size_t undecided = 0;
  for (Candidate candidate : parent) {
    const double d = distance(candidate.component, centre, candidate.hint);
    if (d > radius) continue;
    list.push_back(candidate);
    if (d >= -radius) ++undecided;
  }
  // One undecided component is asked about in any case; dividing further would not spare the question.
  if (undecided < 2 || depth == kDeepest) {
    cells_[cell].first = static_cast<std::uint32_t>(lists_.size());
    cells_[cell].count = static_cast<std::uint32_t>(list.size());
    lists_.insert(lists_.end(), list.begin(), list.end());
    return;
  }
  const auto first_child = static_cast<std::uint32_t>(cells_.size());
  cells_[cell].first_child = first_child;
  cells_.resize(cells_.size() + 8);
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    divide(first_child + octant, child_centre(centre, half_edge, octant), 0.5 * half_edge, list, depth + 1,
           distance);
  }
}

std::span<const Containment::Candidate> Containment::candidates(const Vec3& p) const {
  if (!((p - centre_).cwiseAbs().maxCoeff() <= half_edge_)) return {};  // outside of everything; NaN too
  Vec3 centre = centre_;
  double half_edge = half_edge_;
  std::uint32_t cell = 0;
  while (cells_[cell].first_child != 0) {
    const auto above = [&](Eigen::Index axis) { return p[axis] >= centre[axis] ? 1u : 0u; };
    const std::uint32_t octant = above(0) | above(1) << 1 | above(2) << 2;
    cell = cells_[cell].first_child + octant;
    centre = child_centre(centre, half_edge, octant);
    half_edge *= 0.5;
  }
  return std::span(lists_).subspan(cells_[cell].first, cells_[cell].count);
}

}  // namespace fulcrum
