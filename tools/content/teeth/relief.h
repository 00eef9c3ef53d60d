#pragma once
// The top of a tooth: cusps, the fissures between them, marginal ridges and incisal edges, as a height.

#include <vector>

#include <Eigen/Core>

namespace fulcrum::content {

// A rounded pyramid with four ridges. Its flanks fall between the ridges.
struct Cusp {
  Eigen::Vector3d tip;     // mm
  double inward = 0.0;     // rad from x to y: where the triangular ridge runs
  double ridge = 0.5;      // slope of that ridge
  double flank = 0.85;     // slope beside it
  double crest = 0.4;      // slope of the mesial and the distal ridge
  double outer = 1.3;      // slope towards the outside
  double blunt = 0.5;      // mm, radius of the tip
  double wrinkles = 0.12;  // mm, depth of the small grooves beside the triangular ridge
};

// A crest along a line: marginal ridges, incisal edges, the crests of canines.
struct Ridge {
  Eigen::Vector3d from, to;  // mm
  double sag = 0.0;          // mm, how much lower its middle is
  double slope_left = 0.8;   // of the side on the left, seen from `from` to `to`
  double slope_right = 0.8;
  double blunt = 0.4;  // mm
};

struct Relief {
  std::vector<Cusp> cusps{};
  std::vector<Ridge> ridges{};
  double fissure_depth = 0.0;                // mm, below the valley between two cusps
  double fissure_width = 0.17;               // mm, half
  Eigen::Vector2d fissure_middle{0.0, 0.0};  // mm
  Eigen::Vector2d fissure_reach{4.0, 3.0};   // mm, beyond this ellipse fissures fade
  double waviness = 0.15;                    // mm, no groove of a tooth runs straight
  double phase = 0.0;                        // rad, and none as on the tooth across the jaw
  double join = 0.35;                        // mm, rounding between ridges and cusps

  double height(double x, double y) const;
  // 1 in the middle of a fissure, 0 away from all.
  double fissure(double x, double y) const;

private:
  struct At {
    double height, fissure;
  };
  At at(double x, double y) const;
};

}  // namespace fulcrum::content
