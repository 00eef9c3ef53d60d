#pragma once
// The line on which the teeth of the lower jaw stand, seen from above, and the heights along it.

#include <vector>

#include <Eigen/Core>

namespace fulcrum::content {

// W's millimetres: x to the jaw's left, y up to the upper teeth, z to the front; y is 0 at the incisors'
// edges.
class Arch {
public:
  Arch();

  struct Place {
    Eigen::Vector2d p;        // (x, z) mm
    Eigen::Vector2d onward;   // (x, z) unit, to the jaw's left
    Eigen::Vector2d outward;  // (x, z) unit, to cheeks and lips
  };
  Place at(double along) const;  // mm from the middle; beyond the ends straight on

  struct Foot {
    double along = 0.0;    // mm, of the nearest place
    double outward = 0.0;  // mm, from there: positive at the cheeks' side
  };
  Foot foot(const Eigen::Vector2d& p_xz) const;

  double end() const { return end_; }  // mm, along: behind the last tooth

private:
  std::vector<Eigen::Vector2d> points_;    // (n x 2) mm, equally spaced along
  std::vector<Eigen::Vector2d> tangents_;  // (n x 2) unit, onward
  double end_ = 0.0;
};

// Height (mm) of incisal edges and buccal cusps along the arch: F. von Spee's curve.
double occlusal_height(double along);

}  // namespace fulcrum::content
