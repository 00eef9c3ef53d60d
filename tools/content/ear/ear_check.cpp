#include "tools/content/ear/ear_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double most_fixed = -0.2;            // mm, of room for the best fixed roll
constexpr double least_clearance = 0.25 * mm;  // of the needle on its way
constexpr double grip_begins = 60.0 * mm;      // z: what is beyond never comes near
constexpr double stride = 0.4;                 // mm, along the way

bool within(const char* what, double value, double least, double most) {
  const bool fits = value >= least && value <= most;
  std::printf("%s: %.1f mm (%.1f to %.1f)%s\n", what, value, least, most,
              fits ? "" : ": NOT AS IT SHOULD BE");
  return fits;
}

Eigen::Isometry3d in_millimetres(Eigen::Isometry3d X) {
  X.translation() /= mm;
  return X;
}

}  // namespace

bool check_rolls(const Passage& passage) {
  const Passage::Fixed fixed = passage.best_fixed_roll();
  const bool fits = fixed.clearance <= most_fixed;
  std::printf("room of the needle with a fixed roll: %.2f mm at best, at %d degrees%s\n", fixed.clearance,
              fixed.roll * 360 / rolls, fits ? "" : ": IT NEED NOT BE ROLLED");
  return fits;
}

bool check_way(const std::vector<RoutePose>& route, const TriangleTree& scene, const Model& needle) {
  if (route.empty()) {
    std::printf("THERE IS NO WAY FOR THE NEEDLE\n");
    return false;
  }
  std::vector<Vector3d> points;
  for (const Part& part : needle.parts) {
    for (const Vector3d& p : part.solid.points)
      if (p.z() < grip_begins) points.push_back(p / mm);
  }
  double least = 5 * mm;
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const Eigen::Isometry3d from = in_millimetres(route[i].X_WT);
    const Eigen::Isometry3d to = in_millimetres(route[i + 1].X_WT);
    const double turn = angle_of(Eigen::Quaterniond(from.linear().transpose() * to.linear()));
    const double way = (to.translation() - from.translation()).norm() + 10.0 * turn;
    const int steps = std::max(1, static_cast<int>(std::ceil(way / stride)));
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Isometry3d X_WT = on_the_way(from, to, static_cast<double>(k) / steps);
      for (const Vector3d& p_T : points) least = std::min(least, scene.distance(mm * (X_WT * p_T), least));
    }
  }
  const bool fits = least >= least_clearance;
  std::printf("clearance of the needle on the expert's way: %.2f mm%s\n", least / mm,
              fits ? "" : ": TOO LITTLE");
  return fits;
}

bool check_canal(const Canal& canal) {
  double length = 0.0;
  double narrowest = 100.0;
  constexpr double step = 0.1;
  for (double depth = 0.0; depth < Canal::drum_depth; depth += step) {
    const Vector3d onward = canal.middle(depth + step) - canal.middle(depth);
    length += onward.norm();
    // Across the canal: less than in the level section by the cosine of its slope there.
    const Vector2d half = canal.half_size(depth);
    const double to_front = math::hypot(onward.x(), onward.z());
    const double up = math::hypot(onward.y(), onward.z());
    narrowest = std::min({narrowest, 2.0 * half.x() * step / to_front, 2.0 * half.y() * step / up});
  }
  bool good = within("length of the canal", length, 24.0, 31.0);
  good &= within("width of its opening", 2.0 * canal.half_size(0.0).x(), 6.5, 8.0);
  good &= within("height of its opening", 2.0 * canal.half_size(0.0).y(), 8.0, 10.0);
  good &= within("width of its isthmus", narrowest, 4.8, 6.0);
  good &= within("width of the drum", 2.0 * Canal::drum_half_width, 8.0, 9.0);
  good &= within("height of the drum", 2.0 * Canal::drum_half_height, 9.0, 10.0);
  return good;
}

}  // namespace fulcrum::content
