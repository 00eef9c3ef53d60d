#pragma once
// Pointshell against distance field: which points of the tool are inside the scene, and how far off the
// others are. W. A. McNeely, K. D. Puterbaugh, J. J. Troy, "Six degree-of-freedom haptic rendering using
// voxel sampling", SIGGRAPH 1999; distance fields in place of voxels: J. Barbic, D. L. James, IEEE Trans.
// Haptics 1(1), 2008.

#include <memory>
#include <vector>

#include "haptics/contact/contact_set.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/pose.h"

namespace fulcrum {

class ContactQuery {
public:
  ContactQuery(std::shared_ptr<const Pointshell> shell_T, std::shared_ptr<const DistanceField> field_W);

  struct Outcome {
    bool complete = true;  // false: the set was too small and the shallowest contacts were left out
    bool in_band = true;   // false: a point is so deep inside that its normal is a guess
  };
  // Fills the set for the tool at X_WT with every point that is nearer to the scene than `margin` m.
  Outcome run(const Pose& X_WT, ContactSet& set, double margin = 0.0) noexcept;

  // The largest fraction, 0 to 1, of a motion over which no shell point can enter the scene by more than
  // `allowance` m beyond where it was at the last run(). The field's values are 1-Lipschitz up to its error
  // bound, so a point that travels less than its distance stays out (conservative advancement: Mirtich 1996).
  // The travel of a point is bounded by |v| t + |w| t |p_T|.
  double safe_fraction(double travel, double turn, double allowance) const noexcept;

  std::size_t bytes() const {
    return distance_.capacity() * sizeof(double) + radius_.capacity() * sizeof(double);
  }

private:
  std::shared_ptr<const Pointshell> shell_;
  std::shared_ptr<const DistanceField> field_;
  std::vector<double> distance_;  // (n) m, lower bound at the last run
  std::vector<double> radius_;    // (n) m, |p_T|
  double nearest_ = 0;            // m, the smallest of distance_
};

}  // namespace fulcrum
