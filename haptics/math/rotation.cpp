#include "haptics/math/rotation.h"

#include <cmath>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum {

Vec3 rotation_vector(const Quat& q) {
  const double w = q.w();
  const Vec3 v = q.vec();
  const double sine = v.norm();
  if (sine < 1e-9) return 2.0 * (w < 0 ? Vec3(-v) : v);  // sin(x) = x to rounding
  const double angle = 2.0 * math::atan2(sine, std::abs(w));
  double sign = w < 0 ? -1.0 : 1.0;
  if (w == 0) {
    const double first = v.x() != 0 ? v.x() : (v.y() != 0 ? v.y() : v.z());
    sign = first < 0 ? -1.0 : 1.0;
  }
  return v * (sign * angle / sine);
}

Quat quaternion_exp(const Vec3& rotation) {
  const double angle = rotation.norm();
  const double half = 0.5 * angle;
  const double scale = angle < 1e-8 ? 0.5 : math::sin(half) / angle;
  const Vec3 v = rotation * scale;
  return Quat(math::cos(half), v.x(), v.y(), v.z()).normalized();
}

Vec3 rotation_vector_near(const Quat& q, const Vec3& previous) {
  Vec3 shortest = rotation_vector(q);
  const double angle = shortest.norm();
  if (angle < 1e-9) return shortest;
  const Vec3 longest = shortest * ((angle - 2.0 * std::numbers::pi) / angle);
  return (shortest - previous).squaredNorm() <= (longest - previous).squaredNorm() ? shortest : longest;
}

Quat turn_by(double angle, const Vec3& axis) {
  const double half = 0.5 * angle, sine = math::sin(half);
  return Quat(math::cos(half), sine * axis.x(), sine * axis.y(), sine * axis.z());
}

double angle_of(const Quat& q) {
  return 2.0 * math::atan2(q.vec().norm(), std::abs(q.w()));
}

double angle_between(const Quat& a, const Quat& b) {
  return angle_of(a * b.conjugate());
}

double angle_between(const Vec3& u, const Vec3& v) {
  return math::atan2(u.cross(v).norm(), u.dot(v));
}

Quat slerp(const Quat& from, const Quat& to, double part) {
  const double cosine = from.dot(to), nearer = cosine < 0 ? -1.0 : 1.0;
  double of_from = 1.0 - part, of_to = part;  // in a line, where the angle is lost in rounding
  if (std::abs(cosine) < 1.0 - 1e-15) {
    const double angle = math::acos(std::abs(cosine)), sine = math::sin(angle);
    of_from = math::sin(of_from * angle) / sine;
    of_to = math::sin(of_to * angle) / sine;
  }
  return Quat(of_from * from.coeffs() + nearer * of_to * to.coeffs());
}

}  // namespace fulcrum
