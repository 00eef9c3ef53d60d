#pragma once
// The wrench within a device's motors whose felt force and moment are nearest to those of a whole pulse, with
// nothing kept: a force that is beyond the motors is tilted, and its moment can be more than the contact's.
// To be shown beside what the tick does.

#include "haptics/actuation/actuators.h"

namespace fulcrum::analysis::hardness {

// min |A x - b|^2 with |x_i| <= limit_i. C. L. Lawson, R. J. Hanson, "Solving least squares problems", 1974,
// chapter 23, with bounds on both sides (P. B. Stark, R. L. Parker, "Bounded-variable least-squares", 1995).
Eigen::VectorXd bounded_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                      const Eigen::VectorXd& limits);

// f_D (3) N, p_HG_D (3) m: of the whole pulse. keep_direction: the force is along f_D, and only the moment is
// free.
Wrench nearest_wrench(const Actuators& motors, const Vec3& f_D, const Vec3& p_HG_D, bool keep_direction);

}  // namespace fulcrum::analysis::hardness
