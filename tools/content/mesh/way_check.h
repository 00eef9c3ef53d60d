#pragma once
// Whether a tool that follows the expert's way stays clear of the scene.

#include <span>
#include <vector>

#include "tools/content/mesh/model.h"
#include "tools/content/mesh/triangle_tree.h"
#include "tools/content/mesh/waypoints.h"

namespace fulcrum::content {

TriangleTree tree_of(std::span<const Model> models);

// The least distance (m, at most 5 mm) of a tool's points to the scene on the way. It is looked at so often
// that no point moves farther than `stride` (m) in between. On the ways to and from a pose that presses, only
// the points `may_not_touch` are asked.
double clearance_on_way(const std::vector<RoutePose>& route, const TriangleTree& scene,
                        const std::vector<Eigen::Vector3d>& points_T,
                        const std::vector<Eigen::Vector3d>& may_not_touch_T, double stride);

}  // namespace fulcrum::content
