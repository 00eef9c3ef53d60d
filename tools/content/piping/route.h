#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tools/content/mesh/fasteners.h"
#include "tools/content/piping/flanges.h"
#include "tools/content/piping/spanner.h"

namespace fulcrum::content {

// The places that the route and the piping share. W is the plant's frame, its origin in the middle of the
// plant: x to the right, y up, z towards the viewer.
struct Layout {
  // Two upright pipes hold the spanner on both sides. The slot lies in the plane z = slot_z, half way
  // between them at x = 0.
  static constexpr double slot_pipe_radius = flange_34.pipe_radius;
  static constexpr double slot_gap = SpannerDesign::large.height + 3.0 * mm;
  static constexpr double slot_pipe_x = 0.5 * slot_gap + slot_pipe_radius;
  static constexpr double slot_z = 50 * mm;
  static constexpr double slot_y = 30 * mm;  // height at which the spanner goes through

  // The pocket behind the slot: the spanner dips about the slot and goes on to a nut whose axis lies along
  // x, on the blind flange of the DN 15 line. The nut's end and the ring face each other at this distance.
  static constexpr double nut_standoff = 10 * mm;
  static constexpr double dip = 45.0 * degree;
  static constexpr double nut_y = -45 * mm;
  static constexpr double nut_z = slot_z - (slot_y - nut_y);  // 45 degrees below the slot
  static constexpr double ring_at_nut_x =
      -SpannerDesign::offset;  // the shank is then half way between the pipes
  static constexpr double bolt_end_x = ring_at_nut_x - 0.5 * SpannerDesign::large.height - nut_standoff;
  static constexpr double nut_seat_x = bolt_end_x - stub(m12) - m12.nut_height;
};

struct PlantPose {
  std::string name;  // of a checkpoint; empty for a waypoint between two
  Eigen::Isometry3d X_WT;
};

// Centre of the large ring in T: the point that has to reach the checkpoints.
Eigen::Vector3d touch_point_T();

// From the start in front of the plant to the nut, to be joined by straight lines and shortest turns.
std::vector<PlantPose> route();

// The pose between two poses: straight line of T's origin, shortest turn at constant rate; u in 0..1.
Eigen::Isometry3d between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double u);

// Lists of numbers in YAML: m; (w, x, y, z), body to world.
std::string yaml_position(const Eigen::Vector3d& p);
std::string yaml_orientation(const Eigen::Matrix3d& R);

// The route as YAML.
std::string route_yaml();

}  // namespace fulcrum::content
