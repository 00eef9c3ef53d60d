#include "tools/content/ear/coat.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tools/content/ear/tissue.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

const std::vector<double> surroundings{0.7, 1.8, 4.0, 8.0};  // mm
const std::vector<double> in_the_canal{0.4, 1.0, 2.0};       // mm, or no light would be left at the drum

// Fine pores and lines: so fine that they tilt the normal alone.
Vector3d skin_grain(const Vector3d& p) {
  const Vector3d q = 5.5 * p;
  return 0.035 *
         Vector3d(mottle(q), mottle(q + Vector3d(7.1, 3.3, 1.9)), mottle(q + Vector3d(2.7, 9.1, 5.3)));
}

struct Place {
  Vector3d colour;
  double wetness;
};

constexpr double cut_wetness = 0.45;  // of flesh and bone that is laid open

Place surface_place(const Flesh& flesh, const Vector3d& p) {
  const double in_canal = smooth_step(2.5, -1.0, p.z()) * smooth_step(-1.6, -0.2, flesh.canal().to_wall(p));
  return {mixed(tissue::skin(flesh, p), tissue::lining(p), in_canal), in_canal};
}

Coat coat(const Solid& solid, const Implicit& body,
          const std::function<Vector3d(const Vector3d&)>& colour_at) {
  Coat coat;
  for (const Vector3d& p : solid.points) {
    const Vector3d n = gradient(body, p, 0.12).normalized();
    const bool deep = p.z() < -1.0 && p.head<2>().norm() < 12.0;
    // Deep in the canal it would be dark but for the lamp that everyone who looks in there has.
    const double open =
        deep ? 0.5 + 0.5 * openness(body, p, n, in_the_canal) : openness(body, p, n, surroundings);
    const Vector3d colour = colour_at(p);
    coat.normals.push_back((n + skin_grain(p)).normalized());
    coat.colours.push_back(shut_in(colour, open, colour));
  }
  return coat;
}

MoistCoat moist_coat(const Solid& solid, const Implicit& body,
                     const std::function<Place(const Vector3d&)>& place_at) {
  MoistCoat made;
  made.coat = coat(solid, body, [&](const Vector3d& p) {
    const Place place = place_at(p);
    made.wetness.push_back(place.wetness);
    return place.colour;
  });
  return made;
}

}  // namespace

MoistCoat skin_coat(const Flesh& flesh, const Solid& solid) {
  return moist_coat(
      solid, [&](const Vector3d& p) { return flesh.distance(p); },
      [&](const Vector3d& p) { return surface_place(flesh, p); });
}

MoistCoat open_coat(const Flesh& flesh, const Solid& solid) {
  return moist_coat(
      solid, [&](const Vector3d& p) { return flesh.open_distance(p); },
      [&](const Vector3d& p) -> Place {
        const double to_surface = std::abs(flesh.distance(p));
        if (std::abs(flesh.to_cavity(p)) < 0.12) return {tissue::mucosa(p), 1.0};
        if (to_surface < 0.12) return surface_place(flesh, p);
        return {tissue::cut(flesh, p), cut_wetness};
      });
}

Coat drum_coat(const Flesh& flesh, const Solid& solid, double rim) {
  return coat(
      solid, [&](const Vector3d& p) { return flesh.to_membrane(p, rim); },
      [&](const Vector3d& p) { return tissue::drum(flesh.canal(), p); });
}

}  // namespace fulcrum::content
