#include "haptics/geometry/sphere_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fulcrum {
namespace {

constexpr float kNoBall = std::numeric_limits<float>::quiet_NaN();
constexpr int kBallSteps = 24;      // of M. Badoiu, K. L. Clarkson, "Smaller core-sets for balls", SODA 2003
constexpr double kRounding = 1e-6;  // more than single precision takes off a radius

struct Sphere {
  Vec3 centre;
  double radius;
};

struct Farthest {
  const Vec3* point;
  double distance;
};

Farthest farthest(std::span<const Vec3> points, const Vec3& from) {
  const auto found = std::max_element(points.begin(), points.end(), [&](const Vec3& l, const Vec3& r) {
    return (l - from).squaredNorm() < (r - from).squaredNorm();
  });
  return {&*found, (*found - from).norm()};
}

// From the middle of the box towards whatever is farthest, by ever smaller steps; the best of them.
Sphere small_sphere(std::span<const Vec3> points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  Vec3 centre = box.center();
  Sphere best{centre, std::numeric_limits<double>::infinity()};
  for (int step = 1; step <= kBallSteps; ++step) {
    centre = centre.cast<float>().cast<double>();
    const Farthest far = farthest(points, centre);
    if (far.distance < best.radius) best = {centre, far.distance};
    centre += (*far.point - centre) / (step + 1);
  }
  return best;
}

std::vector<SphereTree::Spheres> spheres_over(std::span<const Vec3> points, std::size_t run) {
  const std::size_t nodes = (points.size() + run - 1) / run;
  std::vector<SphereTree::Spheres> blocks((nodes + kBlock - 1) / kBlock);
  for (std::size_t i = 0; i < blocks.size() * kBlock; ++i) {
    SphereTree::Spheres& block = blocks[i / kBlock];
    const std::size_t lane = i % kBlock, first = std::min(i * run, points.size());
    block.x[lane] = block.y[lane] = block.z[lane] = kNoBall;
    block.radius[lane] = 0;
    if (first == points.size()) continue;
    const Sphere sphere = small_sphere(points.subspan(first, std::min(run, points.size() - first)));
    block.x[lane] = static_cast<float>(sphere.centre.x());
    block.y[lane] = static_cast<float>(sphere.centre.y());
    block.z[lane] = static_cast<float>(sphere.centre.z());
    block.radius[lane] = static_cast<float>(sphere.radius * (1 + kRounding));
  }
  return blocks;
}

}  // namespace

SphereTree build_sphere_tree(const Pointshell& shell_T) {
  SphereTree tree;
  const std::span<const Vec3> points = shell_T.positions;
  tree.patches.resize((points.size() + kBlock - 1) / kBlock);
  for (std::size_t first = 0; first < points.size(); first += kBlock) {
    const auto run = points.subspan(first, std::min(kBlock, points.size() - first));
    SphereTree::Points& patch = tree.patches[first / kBlock];
    patch.x.fill(kNoBall);
    patch.y.fill(kNoBall);
    patch.z.fill(kNoBall);
    Eigen::AlignedBox3d box;
    for (const Vec3& p : run) box.extend(p);
    const Eigen::Vector3f middle = box.center().cast<float>();
    tree.middles.push_back({middle.x(), middle.y(), middle.z()});
    for (std::size_t lane = 0; lane < run.size(); ++lane) {
      const Vec3 offset = run[lane] - middle.cast<double>();
      patch.x[lane] = static_cast<float>(offset.x());
      patch.y[lane] = static_cast<float>(offset.y());
      patch.z[lane] = static_cast<float>(offset.z());
      tree.patch_radius = std::max(tree.patch_radius, offset.norm());
    }
  }
  std::size_t blocks = tree.patches.size();
  for (std::size_t run = kBlock; blocks > 1; run *= kBlock) {
    tree.levels.push_back(spheres_over(points, run));
    blocks = tree.levels.back().size();
  }
  return tree;
}

std::size_t SphereTree::bytes() const {
  std::size_t sum = patches.size() * sizeof(Points) + middles.size() * sizeof middles[0];
  for (const std::vector<Spheres>& level : levels) sum += level.size() * sizeof(Spheres);
  return sum;
}

}  // namespace fulcrum
