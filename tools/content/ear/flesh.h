#pragma once
// The ear on its piece of the head, as one body with the canal in it, and the drum at the canal's end. There
// is also one that is cut open along the canal.

#include "tools/content/ear/canal.h"
#include "tools/content/ear/pinna.h"

namespace fulcrum::content {

class Flesh {
public:
  const Canal& canal() const { return canal_; }
  const Pinna& pinna() const { return pinna_; }

  // About the distance (mm) to the surface of the whole, negative inside.
  double distance(const Eigen::Vector3d& p_W) const;
  // The same of the one that is cut open; behind its drum it has the tympanic cavity.
  double open_distance(const Eigen::Vector3d& p_W) const;

  // How far (mm) before the cut a point lies: positive where the flesh is taken away.
  double before_cut(const Eigen::Vector3d& p_W) const;
  // How far (mm) above the head's skin, without the pinna.
  double above_head(const Eigen::Vector3d& p_W) const;
  double to_cavity(
      const Eigen::Vector3d& p_W) const;  // about the distance (mm) to the tympanic cavity's wall
  // About the distance (mm) to the surfaces of the drum as a membrane, which ends this far (mm) beyond its
  // annulus.
  double to_membrane(const Eigen::Vector3d& p_W, double rim) const;

  static constexpr double buried_rim = 1.6;  // mm, of the membrane: in the flesh all around
  static constexpr double open_rim = 0.7;    // mm, of the one in the ear that is cut open
  static constexpr double back = -36.0;      // mm, z of the flat side of the piece of head
  // The cut faces forwards and up: the way from which the canal's S is seen.
  static inline const Eigen::Vector3d cut_normal = Eigen::Vector3d(0.85, 0.53, 0.0).normalized();

private:
  double solid(const Eigen::Vector3d& p_W) const;  // without the canal

  Canal canal_;
  Pinna pinna_;
};

}  // namespace fulcrum::content
