#include "haptics/bake/union_distance.h"

#include <algorithm>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kRounding = 1e-9;  // m, far above the rounding of distances and far below any voxel

}  // namespace

UnionDistance::UnionDistance(const TriangleDistance& exact, const Solid& solid, const Vec3& centre,
                             double radius)
    : exact_(&exact) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = 0; k < solid.components.size(); ++k) {
    if (solid.components[k].bounds.exteriorDistance(centre) > least + 2.0 * radius + kRounding) continue;
    std::uint32_t hint = solid.components[k].first_triangle;
    const double distance = exact.component_distance(k, centre, hint);
    candidates_.push_back({k, hint, distance, centre});
    least = std::min(least, distance);
  }
  at_centre_ = least;
  keep_near(radius);
}

UnionDistance::UnionDistance(const UnionDistance& parent, const Vec3& centre, double radius)
    : exact_(parent.exact_), candidates_(parent.candidates_), last_(parent.last_) {
  at_centre_ = candidates_[ask(centre)].distance;
  // A candidate that was not asked is known to be no nearer than its last answer less the way from there.
  for (Candidate& candidate : candidates_) {
    candidate.distance -= (candidate.asked - centre).norm();
    candidate.asked = centre;
  }
  keep_near(radius);
}

// Whatever is farther at the centre than the nearest by more than twice the radius is farther everywhere in
// the ball.
void UnionDistance::keep_near(double radius) {
  const double limit = at_centre_ + 2.0 * radius + kRounding;
  std::erase_if(candidates_, [limit](const Candidate& candidate) { return candidate.distance > limit; });
  last_ = 0;
}

std::size_t UnionDistance::ask(const Vec3& p) {
  const auto renew = [&](Candidate& candidate) {
    candidate.distance = exact_->component_distance(candidate.component, p, candidate.hint);
    candidate.asked = p;
  };
  renew(candidates_[last_]);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    Candidate& candidate = candidates_[i];
    const double least = candidates_[last_].distance;
    if (i == last_ || candidate.distance - (candidate.asked - p).norm() > least + kRounding) continue;
    renew(candidate);
    if (candidate.distance < least) last_ = i;
  }
  return last_;
}

double UnionDistance::operator()(const Vec3& p) {
  return candidates_[ask(p)].distance;
}

double UnionDistance::closest(const Vec3& p, Vec3& point) {
  const Candidate& nearest = candidates_[ask(p)];
  point = exact_->closest_on(nearest.hint, p);
  return nearest.distance;
}

}  // namespace fulcrum
