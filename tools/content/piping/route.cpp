#include "tools/content/piping/route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::content {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// The spanner points its large ring away from the viewer, x_T along -z. Rolled, it stands on edge: z_T along
// +x, y_T up. Flat, the rings' axes are upright and the shank is the higher part: z_T up.
Matrix3d pointing(double roll, double dip, double swing) {
  const Matrix3d on_edge = turn_by(0.5 * pi, Vector3d::UnitY()).toRotationMatrix();
  const Matrix3d rolled = on_edge * turn_by(roll, Vector3d::UnitX()).toRotationMatrix();
  return turn_by(swing, Vector3d::UnitY()) * turn_by(-dip, Vector3d::UnitX()) * rolled;
}

constexpr double flat = -90.0 * degree;
constexpr double on_edge = 0.0;

Eigen::Isometry3d pose_of_ring(const Vector3d& ring_W, const Matrix3d& R_WT) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = R_WT;
  X.translation() = ring_W - R_WT * touch_point_T();
  return X;
}

// On edge, its long axis through the slot, the ring `depth` behind the slot's plane along a line that dips.
// What lies between the pipes is kept in the middle of the gap.
Eigen::Isometry3d through_slot(double depth, double dip, double aside) {
  const Vector3d ring(-crank_height(depth) + aside, Layout::slot_y - depth * math::sin(dip),
                      Layout::slot_z - depth * math::cos(dip));
  return pose_of_ring(ring, pointing(on_edge, dip, 0.0));
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6f", std::abs(value) < 5e-7 ? 0.0 : value);
  return text.data();
}

}  // namespace

Vector3d touch_point_T() {
  return Vector3d(SpannerDesign::half_length, 0.0, 0.0) - spanner_centre_of_mass();
}

std::vector<PlantPose> route() {
  const double y = Layout::slot_y;
  const double z = Layout::slot_z;
  const double reach = (Layout::slot_y - Layout::nut_y) / math::sin(Layout::dip);
  std::vector<PlantPose> poses{
      {"start",
       pose_of_ring({-30 * mm, y + 40 * mm, z + 160 * mm}, pointing(flat, 10 * degree, -20 * degree))},
      {"approach", pose_of_ring({0.0, y, z + 95 * mm}, pointing(flat, 0.0, 0.0))},
      {"on edge", pose_of_ring({0.0, y, z + 48 * mm}, pointing(on_edge, 0.0, 0.0))},
      {"", through_slot(-24 * mm, 0.0, 0.0)},
      {"between the pipes", through_slot(0.0, 0.0, 0.0)},
  };
  // The crank needs the spanner to move sideways while it goes through: short steps follow its curve.
  constexpr double crank_step = 3.0 * mm;
  for (double depth = 12 * mm; depth < SpannerDesign::crank_end; depth += crank_step)
    poses.push_back({"", through_slot(depth, 0.0, 0.0)});
  poses.push_back({"behind the pipes", through_slot(46 * mm, 0.0, 0.0)});
  constexpr int dip_steps = 6;
  for (int i = 1; i <= dip_steps; ++i) {
    const double u = static_cast<double>(i) / dip_steps;
    poses.push_back({"", through_slot((46 + 32 * u) * mm, u * Layout::dip, 0.0)});
  }
  poses.push_back({"at the nut", through_slot(reach, Layout::dip, 0.0)});
  return poses;
}

Eigen::Isometry3d between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double u) {
  const Eigen::Quaterniond q_from(from.linear());
  const Eigen::Quaterniond q_to(to.linear());
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = slerp(q_from, q_to, u).toRotationMatrix();
  X.translation() = (1.0 - u) * from.translation() + u * to.translation();
  return X;
}

std::string yaml_position(const Vector3d& v) {
  return "[" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + "]";
}

std::string yaml_orientation(const Matrix3d& R) {
  Eigen::Quaterniond q(R);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return "[" + number(q.w()) + ", " + number(q.x()) + ", " + number(q.y()) + ", " + number(q.z()) + "]";
}

std::string route_yaml() {
  std::string text =
      "# Poses of the spanner in the plant: metres; quaternions (w, x, y, z), body to world.\n"
      "# Named poses are the start and the checkpoints; touch_W is where the large ring's centre has to "
      "be.\n";
  text += "touch_point_T: " + yaml_position(touch_point_T()) + "\n";
  text += "route:\n";
  for (const PlantPose& pose : route()) {
    text += "  - p_WT: " + yaml_position(pose.X_WT.translation()) + "\n";
    text += "    q_WT: " + yaml_orientation(pose.X_WT.linear()) + "\n";
    if (pose.name.empty()) continue;
    text += "    name: " + pose.name + "\n";
    text += "    touch_W: " + yaml_position(pose.X_WT * touch_point_T()) + "\n";
  }
  return text;
}

}  // namespace fulcrum::content
