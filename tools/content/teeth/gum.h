#pragma once
// The gum about the teeth and the ridge of the jaw below it, as a formula.

#include "tools/content/teeth/dentition.h"

namespace fulcrum::content {

class Gum {
public:
  explicit Gum(const Dentition& dentition);

  // About the distance (mm) to the gum's surface, negative inside. It fills the necks of the teeth.
  double distance(const Eigen::Vector3d& p_W) const;

  // How far (mm) below the gum's margin a point lies, measured along the teeth's axes.
  double below_margin(const Eigen::Vector3d& p_W) const;

  static constexpr double base = -20.5;  // mm, y of the flat underside

private:
  struct Margin {
    double below = 0.0;       // mm
    double slope = 0.0;       // of the margin along the arch
    double under_neck = 0.0;  // mm, below the cervical lines
    double to_teeth = 0.0;    // mm, to the necks of the teeth
  };
  Margin margin(const Eigen::Vector3d& p_W, const Arch::Foot& foot) const;
  double ridge(const Eigen::Vector3d& p_W, const Arch::Foot& foot) const;

  const Dentition& dentition_;
};

}  // namespace fulcrum::content
