#pragma once

#include <string>

#include "tools/content/teeth/crown_body.h"
#include "tools/content/teeth/relief.h"

namespace fulcrum::content {

// What a kind of tooth looks like, in mm and in its own coordinates: x mesial, y buccal, z occlusal.
struct ToothDesign {
  std::string kind;  // "first molar"
  CrownBody body;
  Relief relief;
  double edge = 0.8;      // mm, rounding between the sides and the top
  double cell = 0.2;      // mm, what of it has to be seen
  double contact = 0.75;  // of the crown's length: how high it touches its neighbours
  double cervical_bow =
      1.0;  // mm, how much higher the cervical line is between the teeth than on the buccal side

  // About the distance (mm) to the tooth's surface.
  double distance(const Eigen::Vector3d& p) const;
};

// A tooth in the jaw. W's millimetres here; the models are in metres.
struct Tooth {
  int number = 0;  // ISO 3950: 31 to 37 on the jaw's left, 41 to 47 on its right
  ToothDesign design;
  double size = 1.0;          // how large it is for its kind
  double crown_length = 0.0;  // mm, of its kind
  Eigen::Matrix3d R_WT;       // its columns are mesial, buccal and occlusal; of the left side it mirrors
  Eigen::Vector3d p_WT;       // (3) mm, the middle of the tooth at its cervical line
  double along = 0.0;         // mm, along the arch from its middle; positive on the jaw's left
  double half_width = 0.0;    // mm, along the arch

  Eigen::Vector3d to_tooth(const Eigen::Vector3d& p_W) const {
    return R_WT.transpose() * (p_W - p_WT) / size;
  }
  Eigen::Vector3d to_world(const Eigen::Vector3d& p_T) const { return size * (R_WT * p_T) + p_WT; }
  double distance(const Eigen::Vector3d& p_W) const { return size * design.distance(to_tooth(p_W)); }
};

}  // namespace fulcrum::content
