#include "engine/analysis/uniformity/inertia_checks.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "haptics/actuation/mechanism.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"

namespace fulcrum::analysis::uniformity {
namespace {

constexpr int kCases = 2000;

Vec3 random_vector(SplitMix& random) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return 2 * Vec3(x, y, z) - Vec3::Ones();
}

// At G, p_HG from C, of a wrench commanded at C while the mass there accelerates.
Wrench felt(const Wrench& commanded, const Vec3& p_HG, const Vec3& inertia) {
  return Wrench{commanded.force - inertia, commanded.torque}.moved_by(p_HG);
}

double off(const Wrench& a, const Wrench& b) {
  return std::max((a.force - b.force).norm() / b.force.norm(),
                  (a.torque - b.torque).norm() / b.torque.norm());
}

double check_control_point(const DeviceDesc& device) {
  SplitMix random(1);
  Mechanism arm(device.mechanism);
  double worst = 0;
  for (int i = 0; i < kCases; ++i) {
    const Vec3 place = 0.5 * device.workspace.cwiseProduct(random_vector(random));
    arm.follow({quaternion_exp(0.3 * random_vector(random)), place});
    const Vec3 held = 0.2 * random_vector(random), used = 0.2 * random_vector(random);
    const Wrench F{random_vector(random), 0.1 * random_vector(random)};
    Vec6 rows;
    rows << F.force, F.torque;
    const Mat6 J_true = arm.jacobian(held).leftCols<6>(), J_used = arm.jacobian(used).leftCols<6>();
    const Vec6 at_hand = J_true.transpose().fullPivLu().solve(J_used.transpose() * rows);
    worst = std::max(worst, off({at_hand.head<3>(), at_hand.tail<3>()}, F.moved_by(held - used)));
  }
  return worst;
}

}  // namespace

InertiaChecks check_inertia(const DeviceDesc& device) {
  InertiaChecks checks;
  const Vec3 l(0.1, 0, 0), g(0.07, 0, 0), h = l - g, f(0, 1, 0), inertia(0, 0.25, 0);
  checks.wanted = h.cross(f).z();
  checks.uncompensated = felt({f, l.cross(f)}, g, inertia).torque.z();
  checks.as_printed = felt({f + inertia, l.cross(f) - l.cross(inertia)}, g, inertia).torque.z();
  if (device.kinematics == Kinematics::arms && Mechanism::motors(device.mechanism) == 6)
    checks.control_point = check_control_point(device);
  return checks;
}

}  // namespace fulcrum::analysis::uniformity
