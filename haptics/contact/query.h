#pragma once
// Pointshell against distance field: which points of the tool are inside the scene, and how far it may move.
// Or the other way about: points of the scene against a field of the tool.
// W. A. McNeely, K. D. Puterbaugh, J. J. Troy, "Six degree-of-freedom haptic rendering using
// voxel sampling", SIGGRAPH 1999; distance fields in place of voxels, and a hierarchy over the points: J.
// Barbic, D. L. James, IEEE Trans. Haptics 1(1), 2008.

#include <limits>
#include <memory>
#include <vector>

#include "haptics/contact/contact_set.h"
#include "haptics/contact/field_normals.h"
#include "haptics/contact/shell_walk.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/geometry/sphere_tree.h"
#include "haptics/math/pose.h"

namespace fulcrum {

class ContactQuery {
public:
  ContactQuery(const std::shared_ptr<const Pointshell>& shell_T, std::shared_ptr<const DistanceField> field_W,
               Normals normals = Normals::across_cells);
  // Points of the scene, numbered from first_point on, for a tool that reaches tool_radius m from T.
  static ContactQuery of_scene(std::shared_ptr<const Pointshell> shell_W,
                               std::shared_ptr<const DistanceField> field_T, Normals normals,
                               std::uint32_t first_point, double tool_radius);

  struct Outcome {
    bool complete = true;  // false: the set was too small and neighbours were taken together
    bool in_band = true;   // false: a point is so deep inside that its normal is a guess
  };
  // Fills the set for the tool at X_WT, in the order of the shell: every point whose distance is below
  // `margin`. Past the field's band distances are lower bounds, and of the points that only their bound
  // brings below a margin wider than the band, some are missing. Depths in band are rounding() off at most,
  // nanometres.
  Outcome run(const Pose& X_WT, ContactSet& set, double margin = 0) noexcept;
  // The same after what is in the set already, whose points have lower numbers.
  Outcome add(const Pose& X_WT, ContactSet& set, double margin) noexcept;

  // The largest fraction, 0 to 1, of a motion over which no shell point can enter the scene by more than
  // `allowance` m beyond where it was at the last run(). The field's values are 1-Lipschitz up to its error
  // bound, so a point that travels less than its distance stays out (conservative advancement: Mirtich 1996).
  // The travel of a point is bounded by |v| t + |w| t |p_T|; of a point of the scene, seen from the tool, by
  // the same with its distance from T, which |v| t may add to. Points whose distance is `known` m or more may
  // not enter at all.
  double safe_fraction(double travel, double turn, double allowance,
                       double known = std::numeric_limits<double>::infinity()) const noexcept;

  double rounding() const { return rounding_; }  // m, of depths by single precision
  std::size_t bytes() const { return tree_.bytes() + brick_slack_.size() * sizeof(float); }

private:
  enum class Points { of_tool, of_scene };
  ContactQuery(std::shared_ptr<const Pointshell> shell, std::shared_ptr<const DistanceField> field,
               Normals normals, Points points, std::uint32_t first_point, double tool_radius);

  Pose shell_in_field() const noexcept { return points_ == Points::of_tool ? X_WT_ : X_WT_.inverse(); }
  ShellWalk walk(double margin) const noexcept;
  void find_normals(std::span<Contact> contacts) const noexcept;

  std::shared_ptr<const Pointshell> shell_;     // in T, or in W
  std::shared_ptr<const DistanceField> field_;  // in W, or in T
  Normals normals_;
  Points points_;
  std::uint32_t first_point_;
  double tool_radius_;  // m
  SphereTree tree_;
  FieldView view_;
  double rounding_ = 0;
  double rounding_far_ = 0;  // m, of what the field says outside the stored bricks, and of nodes
  double overestimate_ = 0;  // m, most by which a distance exceeds the exact one
  std::vector<float> brick_slack_;
  Pose X_WT_;  // at the last run
};

}  // namespace fulcrum
