#pragma once
// What Fulcrum's contact query costs, what reading the field alone costs, and where its depths err.

#include <memory>
#include <vector>

#include "haptics/contact/field_normals.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"
#include "tests/bench/contact_workload.h"

namespace fulcrum::bench {

using Field = std::shared_ptr<const DistanceField>;
using Shell = std::shared_ptr<const Pointshell>;

struct QueryCost {
  double median_us, p99_us;
  double contacts;        // mean
  double touching_share;  // of the surface's area, mean
  double floor_ns;        // a point: four gathers at the addresses of the poses' points, and no arithmetic
  std::size_t points;

  double over_floor(double us) const { return 1e3 * us / (floor_ns * static_cast<double>(points)); }
};

// Reads the field once through: what of it the machine has put aside is there again.
void touch(const DistanceField& field);

// Every pose once, warm. Normals as the default response wants them, the constraint.
QueryCost cost_of_queries(const Field& field, const Shell& shell, const std::vector<Pose>& poses,
                          Normals normals = Normals::of_cell);

// Every point touches: the points of one pipe, moved inwards.
QueryCost cost_of_all_touching(const Workload& workload, const Field& field, std::size_t points);

// The deepest contact against the truth, in per cent of the true depth. The three shares add up to the mean
// by which it falls short.
struct DepthError {
  double percent;   // mean of the amount
  double sampling;  // no shell point lies where the surface is deepest
  double mesh;      // triangles in place of swept circles
  double field;     // the stored field in place of the triangles
};
DepthError depth_error(const Workload& workload, const Field& field, const Shell& shell,
                       const std::vector<Pose>& poses);

}  // namespace fulcrum::bench
