#include "tools/content/ear/canal.h"

// The canal's course: H. Gray, "Anatomy of the Human Body", 1918, "The External Acoustic Meatus": inwards,
// forwards and slightly upwards; then inwards and backwards; then inwards, forwards and slightly downwards.
// Lengths and widths are assumed: ordinary adult figures, not checked against a source.

#include <algorithm>

#include "haptics/math/functions.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double cone = 1.7;  // mm, how far the umbo is drawn in

// Where the handle of the malleus ends at the top, in the drum's plane (mm): its lateral process.
const Vector2d process(0.9, 3.1);

double to_malleus(double x, double y) {
  const Vector2d p(x, y);
  const double t = std::clamp(p.dot(process) / process.squaredNorm(), 0.0, 1.0);
  return (p - t * process).norm();
}

}  // namespace

Canal::Canal()
    : to_front_(
          {{-6, -2.2}, {0, 0.0}, {4.5, 1.7}, {11.5, -2.25}, {15, -1.1}, {20, 2.2}, {24.5, 4.3}, {30, 6.0}}),
      up_({{-6, 0.9}, {0, 0.0}, {4.5, -0.9}, {11.5, 1.9}, {15, 1.05}, {20, -1.2}, {24.5, -2.6}, {30, -4.2}}),
      half_width_({{-6, 4.4},
                   {-1, 3.7},
                   {4, 3.5},
                   {10, 3.15},
                   {15, 2.95},
                   {19, 3.25},
                   {23, 4.3},
                   {26, 4.1},
                   {30, 4.1}}),
      half_height_({{-6, 5.4},
                    {-1, 4.6},
                    {4, 4.1},
                    {10, 3.25},
                    {15, 3.0},
                    {19, 3.3},
                    {23, 4.2},
                    {26, 4.0},
                    {30, 4.0}}) {
  // It faces outwards, forwards and down, as the drum of a grown person does.
  const Vector3d z = Vector3d(0.12, -0.36, 0.92).normalized();
  const Vector3d x = Vector3d::UnitY().cross(z).normalized();
  X_WD_.setIdentity();
  X_WD_.linear().col(0) = x;
  X_WD_.linear().col(1) = z.cross(x);
  X_WD_.linear().col(2) = z;
  X_WD_.translation() = middle(drum_depth);
}

Vector3d Canal::middle(double depth) const {
  return {to_front_(depth), up_(depth), -depth};
}

Vector2d Canal::half_size(double depth) const {
  return {half_width_(depth), half_height_(depth)};
}

// The wall of the last few mm, which narrow to the annulus.
double Canal::to_sulcus(const Vector3d& p_W) const {
  const Vector3d p = X_WD_.inverse() * p_W;
  const double beyond = drum_half_width * (drum_part(p.x(), p.y()) - 1.0);
  return 0.75 * (0.3 + 1.1 * std::max(p.z(), 0.0) - beyond);
}

double Canal::to_wall(const Vector3d& p) const {
  return smooth_min(to_tube(p), to_sulcus(p), 0.8);
}

double Canal::to_tube(const Vector3d& p) const {
  const double depth = -p.z();
  const auto gauge = [&](double d) {
    const Vector3d m = middle(d);
    const Vector2d h = half_size(d);
    return math::hypot((p.x() - m.x()) / h.x(), (p.y() - m.y()) / h.y());
  };
  const Vector3d m = middle(depth);
  const Vector2d h = half_size(depth);
  const double r = gauge(depth);
  if (r < 1e-6) return std::min(h.x(), h.y());
  const double along = (gauge(depth + 0.05) - gauge(depth - 0.05)) / 0.1;
  const double slope =
      Vector3d((p.x() - m.x()) / (h.x() * h.x() * r), (p.y() - m.y()) / (h.y() * h.y() * r), along).norm();
  return (1.0 - r) / slope;
}

double Canal::malleus(double x, double y) const {
  const double along = Vector2d(x, y).dot(process) / process.squaredNorm();
  const double width = 0.5 + 0.25 * std::clamp(along, 0.0, 1.0);
  return bump(to_malleus(x, y), width);
}

double Canal::drum_part(double x, double y) const {
  return math::hypot(x / drum_half_width, y / drum_half_height);
}

double Canal::drum_height(double x, double y) const {
  const double part = drum_part(x, y);
  // Drawn in to the umbo, and bulging a little on the way there.
  double height = -cone * (1.0 - math::pow(math::hypot(std::min(part, 1.0), 0.12), 0.9));
  height += 0.4 * malleus(x, y) + 0.45 * bump((Vector2d(x, y) - process).norm(), 0.55);
  height += 0.3 * bump(drum_half_width * (part - 1.0), 0.4);  // the annulus
  return height;
}

double Canal::to_drum(const Vector3d& p_W) const {
  const Vector3d p = X_WD_.inverse() * p_W;
  return 0.9 * (p.z() - drum_height(p.x(), p.y()));
}

double Canal::room(const Vector3d& p_W) const {
  return smooth_min(to_wall(p_W), to_drum(p_W), 0.6);
}

}  // namespace fulcrum::content
