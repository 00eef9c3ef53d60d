#pragma once
// The ear canal and the drum at its end, as formulas. A right ear in W's millimetres: x to the patient's
// front, y up, z out of the head, the middle of the canal's opening at the origin.

#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

class Canal {
public:
  Canal();

  // The middle of the canal at a depth (mm) below its opening; negative: outside, in the concha.
  Eigen::Vector3d middle(double depth) const;
  // Half width to the front and half height there (mm), of the section that is level with the opening.
  Eigen::Vector2d half_size(double depth) const;

  // About how much room (mm) there is from a point of the canal to its wall, and to the drum; negative: in
  // them.
  double to_wall(const Eigen::Vector3d& p_W) const;
  double to_drum(const Eigen::Vector3d& p_W) const;
  double room(const Eigen::Vector3d& p_W) const;

  // The drum's frame: its origin in the plane of the annulus over the umbo, x to the front, y up along the
  // drum, z into the canal.
  const Eigen::Isometry3d& X_WD() const { return X_WD_; }
  // Height (mm) of the drum over the plane of its annulus, at a place of that plane.
  double drum_height(double x, double y) const;
  // How much of the handle of the malleus shows through there, 0 to 1.
  double malleus(double x, double y) const;

  // How far out on the drum a place lies: 0 over the umbo, 1 at the annulus.
  double drum_part(double x, double y) const;

  static constexpr double drum_half_width = 4.2;   // mm, of the annulus
  static constexpr double drum_half_height = 4.9;  // mm
  static constexpr double drum_depth = 24.5;       // mm, of the origin of its frame

private:
  double to_tube(const Eigen::Vector3d& p_W) const;
  double to_sulcus(const Eigen::Vector3d& p_W) const;

  Profile to_front_, up_, half_width_, half_height_;  // over the depth
  Eigen::Isometry3d X_WD_;
};

}  // namespace fulcrum::content
