#include "tools/content/mesh/way_check.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double far = 5.0 * mm;  // nobody asks for clearances beyond

double reach_of(const std::vector<Vector3d>& points_T) {
  double reach = 0.0;
  for (const Vector3d& p : points_T) reach = std::max(reach, p.norm());
  return reach;
}

}  // namespace

TriangleTree tree_of(std::span<const Model> models) {
  TriangleTree tree;
  for (const Model& model : models)
    for (const Part& part : model.parts) tree.add(part.solid);
  tree.build();
  return tree;
}

double clearance_on_way(const std::vector<RoutePose>& route, const TriangleTree& scene,
                        const std::vector<Vector3d>& points_T, const std::vector<Vector3d>& may_not_touch_T,
                        double stride) {
  const double reach = reach_of(points_T);
  double least = far;
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const bool lets_down = route[i].presses || route[i + 1].presses;
    const Vector3d from = route[i].X_WT.translation();
    const Vector3d step = route[i + 1].X_WT.translation() - from;
    const Eigen::Quaterniond q_from(route[i].X_WT.linear());
    const Eigen::Quaterniond q_to(route[i + 1].X_WT.linear());
    const double way = step.norm() + reach * angle_between(q_from, q_to);
    const int steps = std::max(1, static_cast<int>(std::ceil(way / stride)));
    for (int k = 0; k <= steps; ++k) {
      const double u = static_cast<double>(k) / steps;
      Eigen::Isometry3d X_WT = Eigen::Isometry3d::Identity();
      X_WT.linear() = slerp(q_from, q_to, u).toRotationMatrix();
      X_WT.translation() = from + u * step;
      for (const Vector3d& p_T : lets_down ? may_not_touch_T : points_T)
        least = scene.distance(X_WT * p_T, least);
    }
  }
  return least;
}

}  // namespace fulcrum::content
