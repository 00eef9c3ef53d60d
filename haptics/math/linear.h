#pragma once
// The vector types of the haptic core. SI units, right-handed, Y up.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fulcrum {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Quat = Eigen::Quaterniond;  // (w, x, y, z), body to world

}  // namespace fulcrum
