#include "haptics/device/held_handle.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

using Mat36 = Eigen::Matrix<double, 3, 6>;

constexpr double kSubstep = 0.1e-3;  // s, at most
constexpr int kMaxSweeps = 200;      // at most, where an axis sticks or turns back
constexpr double kStill = 1e-12;     // m/s or rad/s

Mat3 cross(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

double sign(double x) {
  return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0;
}

}  // namespace

void HeldHandle::advance(const Load& load, double tick_s) noexcept {
  const int parts = std::max(1, static_cast<int>(std::ceil(tick_s / kSubstep - 1e-9)));
  const double h = tick_s / parts;
  felt_ = {};
  for (int part = 0; part < parts; ++part) {
    const double t = (part + 0.5) * h;
    const Pose wanted{quaternion_exp(load.V_wanted.w * t) * load.X_DH_wanted.q,
                      load.X_DH_wanted.p + load.V_wanted.v * t};
    substep(load, wanted, h);
  }
  felt_ = felt_ * (1.0 / parts);
}

// One sub-step, the hand where it is in its middle.
void HeldHandle::substep(const Load& load, const Pose& X_DH_wanted, double h) noexcept {
  const Mat3 R = X_DH_.q.toRotationMatrix();
  const Vec3 r_D = R * load.p_HG;
  Mat36 G;
  G << Mat3::Identity(), -cross(r_D) * R;
  Mat36 turns;
  turns << Mat3::Zero(), R;
  const Figures& f = figures_;
  const Mat6 at_G = G.transpose() * G, about = turns.transpose() * turns;
  Mat6 mass = f.hand_mass * at_G;
  mass.diagonal() += f.mass;
  Mat6 damping = f.hand_damping * at_G + f.angular_damping * about;
  damping.diagonal() += f.damping;
  const Mat6 stiffness = f.stiffness * at_G + f.angular_stiffness * about;
  const Vec3 apart_D = X_DH_wanted * load.p_HG - (X_DH_.p + r_D);
  const Vec3 turn_D = rotation_vector(X_DH_wanted.q * X_DH_.q.conjugate());
  const Vec3 v_wanted = load.V_wanted.v + load.V_wanted.w.cross(Vec3(X_DH_wanted.q * load.p_HG));
  const Vec3 w_D = turns * V_;
  const Vec3 centripetal = w_D.cross(w_D.cross(r_D));

  Vec6 force =
      G.transpose() * (f.stiffness * apart_D + f.hand_damping * v_wanted - f.hand_mass * centripetal) +
      turns.transpose() * (f.angular_stiffness * turn_D + f.angular_damping * load.V_wanted.w);
  force.head<3>() += load.F_H_D.force;
  force.tail<3>() += R.transpose() * load.F_H_D.torque;
  const Mat6 A = mass + 0.5 * h * damping + 0.25 * h * h * stiffness;
  const Vec6 w = middle(A, mass * V_ + 0.5 * h * force, h);

  const Vec3 a_G = G * (2 / h * (w - V_)) + centripetal;
  felt_.force -=
      f.stiffness * (apart_D - 0.5 * h * (G * w)) + f.hand_damping * (v_wanted - G * w) - f.hand_mass * a_G;
  felt_.torque -= f.angular_stiffness * (turn_D - 0.5 * h * (turns * w)) +
                  f.angular_damping * (load.V_wanted.w - turns * w);
  for (Eigen::Index i = 0; i < 6; ++i) V_[i] = w[i] == 0 ? 0.0 : 2 * w[i] - V_[i];  // what sticks, rests
  X_DH_.p += h * w.head<3>();
  X_DH_.q = (quaternion_exp(h * (turns * w)) * X_DH_.q).normalized();
}

// Where every axis slides on as it did, one solution of linear equations; else along one axis after the other
// until nothing changes.
Vec6 HeldHandle::middle(const Mat6& A, const Vec6& r, double h) const noexcept {
  const Vec6 rubs = 0.5 * h * figures_.friction;
  const Vec6 way = V_.unaryExpr(&sign);
  Vec6 w = A.llt().solve(r - rubs.cwiseProduct(way));
  const Vec6 slides = w.unaryExpr(&sign);
  if ((slides.array() == way.array() || rubs.array() == 0).all()) return w;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    double moved = 0;
    for (Eigen::Index i = 0; i < 6; ++i) {
      const double push = r[i] - A.row(i).dot(w) + A(i, i) * w[i];
      const double next = sign(push) * std::max(0.0, std::abs(push) - rubs[i]) / A(i, i);
      moved = std::max(moved, std::abs(next - w[i]));
      w[i] = next;
    }
    if (moved < kStill) break;
  }
  return w;
}

}  // namespace fulcrum
