#include "haptics/contact/friction.h"

#include <algorithm>

#include "haptics/math/clamp_norm.h"
#include "haptics/math/functions.h"
#include "haptics/math/number_text.h"

namespace fulcrum {
namespace {

constexpr int kSweeps = 40;
constexpr double kSettled = 1e-9;  // of the largest normal force: a sweep that changes less is the last

Vec6 about_T(const Vec3& force_W, const Vec3& torque_W, const Vec3& r_W) {
  Vec6 F;
  F << force_W, torque_W + r_W.cross(force_W);
  return F;
}

// The torque that keeps the tool from turning, as far as spinning and rolling friction can.
Vec3 wanted_torque(const RubbingPoint& point, const ContactDesc& contact, const Vec3& torque_W) {
  const Vec3 spin = point.nhat_W * point.nhat_W.dot(torque_W), roll = torque_W - spin;
  return clamp_norm(spin, contact.torsional_friction * point.normal_force) +
         clamp_norm(roll, contact.rolling_friction * point.normal_force);
}

// m/N, as of RubbingPoint.
double mobility(const RubbingPoint& point, const Vec6& metric) {
  const Vec3 t = point.nhat_W.unitOrthogonal(), u = point.nhat_W.cross(t);
  const Vec3 turn_t = point.r_W.cross(t), turn_u = point.r_W.cross(u);
  const double k = metric[0], k_R = metric[3];
  const double tt = turn_t.squaredNorm(), uu = turn_u.squaredNorm(), tu = turn_t.dot(turn_u);
  const double largest = 0.5 * (tt + uu) + math::hypot(0.5 * (tt - uu), tu);
  return 1 / k + largest / k_R;
}

}  // namespace

Vec6 rub(const Vec6& metric, const ContactDesc& contact, Vec6& step, const Vec3& turned_W,
         std::span<RubbingPoint> points) noexcept {
  const bool turns = contact.torsional_friction > 0 || contact.rolling_friction > 0;
  const Vec3 k_R = metric.tail<3>();
  double largest = 0;
  for (RubbingPoint& point : points) {
    largest = std::max(largest, point.normal_force);
    point.mobility = mobility(point, metric);
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double changed = 0;
    for (RubbingPoint& point : points) {
      const Vec3 moved = step.head<3>() + step.tail<3>().cross(point.r_W) + point.slip_W;
      const Vec3 along = moved - point.nhat_W * point.nhat_W.dot(moved);
      Vec3 wanted = point.force_W - along / point.mobility;
      wanted -= point.nhat_W * point.nhat_W.dot(wanted);  // a guess may be of another normal
      const double most = contact.friction * point.normal_force, size = wanted.norm();
      if (size > most) wanted *= most / size;
      const Vec3 change = wanted - point.force_W;
      step += about_T(change, Vec3::Zero(), point.r_W).cwiseQuotient(metric);
      point.force_W = wanted;
      changed = std::max(changed, change.norm());
      if (!turns) continue;
      const Vec3 turned = step.tail<3>() + turned_W;
      const Vec3 torque = wanted_torque(point, contact, point.torque_W - k_R.cwiseProduct(turned));
      const Vec3 turn = (torque - point.torque_W).cwiseQuotient(k_R);
      step.tail<3>() += turn;
      point.torque_W = torque;
      changed = std::max(changed, turn.norm() / point.mobility);
    }
    if (changed <= kSettled * largest) break;
  }
  Vec6 sum = Vec6::Zero();
  for (const RubbingPoint& point : points) sum += about_T(point.force_W, point.torque_W, point.r_W);
  return sum;
}

std::string friction_note(const ContactDesc& contact) {
  std::string note;
  if (contact.friction > 0) note += ", friction " + number_text(contact.friction);
  if (contact.torsional_friction > 0)
    note += ", " + number_text(contact.torsional_friction * 1e3) + " mm against spinning";
  if (contact.rolling_friction > 0)
    note += ", " + number_text(contact.rolling_friction * 1e3) + " mm against rolling";
  return note;
}

}  // namespace fulcrum
