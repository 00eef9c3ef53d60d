#pragma once
// Eigen's types as GLM's.

#include <glm/glm.hpp>

#include "haptics/math/pose.h"

namespace fulcrum::scenario {

inline glm::vec3 narrowed(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline glm::mat4 to_glm(const Pose& X) {
  const Eigen::Matrix3f R = X.q.toRotationMatrix().cast<float>();
  const Eigen::Vector3f p = X.p.cast<float>();
  glm::mat4 M(1.0F);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) M[column][row] = R(row, column);
  for (int row = 0; row < 3; ++row) M[3][row] = p[row];
  return M;
}

}  // namespace fulcrum::scenario
