#pragma once
// The pinna, as a formula: a sheet of skin and cartilage that stands off the head and is hollowed out to the
// concha, with the helix around it, the antihelix and its two crura on it, and the tragus and antitragus over
// the canal's opening. W's millimetres, as in canal.h.

#include <vector>

#include "tools/content/ear/cord.h"
#include "tools/content/ear/outline.h"

namespace fulcrum::content {

class Pinna {
public:
  Pinna();

  // About the distance (mm) to its surface, negative inside.
  double distance(const Eigen::Vector3d& p_W) const;

  // How deep (0 to 1) in the concha a place lies.
  double concha(double x, double y) const;

private:
  // The sheet over a place: the height of its middle, how steep it is, how far beyond its edge the place is.
  struct Place {
    double z, slope, beyond, concha;
  };
  Place computed(double x, double y) const;
  Place at(double x, double y) const;  // from the table
  double in_concha(double x, double y) const;
  double height(double x, double y) const;

  Outline edge_, concha_;
  std::vector<Cord> cords_;
  std::vector<Place> table_;
};

}  // namespace fulcrum::content
