#include "tools/content/teeth/explorer.h"

#include <algorithm>
#include <cmath>

#include "tools/content/mesh/tube.h"
#include "tools/content/teeth/profile.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr int columns = 28;

// The axis, walked from the tip: straight up, over the hook, down a little, and out along shank and handle.
struct Stretch {
  double length;  // m
  double turn;    // rad, from up towards the viewer
};

constexpr Stretch stretches[] = {
    {4.5 * mm, 0.0}, {8.6 * mm, 98 * degree}, {4.5 * mm, 0.0}, {7.5 * mm, -44 * degree}, {128 * mm, 0.0},
};
constexpr double handle_begins = 45 * mm;  // along the axis, from the tip

// The radius along the axis: a fine point, the taper of the working end, the shank, a collar, the handle.
const Profile& radius() {
  static const Profile profile({{0, explorer_tip_radius},
                                {1 * mm, 0.27 * mm},
                                {8 * mm, 0.5 * mm},
                                {18 * mm, 0.85 * mm},
                                {30 * mm, 1.25 * mm},
                                {38 * mm, 1.55 * mm},
                                {handle_begins, 3.1 * mm},
                                {handle_begins + 3 * mm, 3.5 * mm},
                                {handle_begins + 24 * mm, 3.0 * mm},
                                {handle_begins + 45 * mm, 3.6 * mm},
                                {handle_begins + 95 * mm, 3.6 * mm},
                                {handle_begins + 104 * mm, 3.2 * mm}});
  return profile;
}

// Rings cut into the grip, and a few more near the handle's end.
double cut(double along) {
  const double grip = along - handle_begins;
  const bool at_grip = grip > 5 * mm && grip < 29 * mm;
  const bool at_end = grip > 84 * mm && grip < 93 * mm;
  if (!at_grip && !at_end) return 0.0;
  const double wave = 0.5 - 0.5 * std::cos(2.0 * pi * (grip - 5 * mm) / (1.5 * mm));
  return 0.35 * mm * wave * wave;
}

double step(double along) {
  if (along < 14 * mm) return 0.35 * mm;
  const double grip = along - handle_begins;
  const bool ringed = (grip > 4 * mm && grip < 30 * mm) || (grip > 83 * mm && grip < 94 * mm);
  return ringed ? 0.19 * mm : 0.7 * mm;
}

// A round cap about the end at `pole`, whose centre lies `inward` of it: from the pole to the full radius or
// back.
std::vector<Station> cap(const Vector3d& centre, const Vector3d& outward, const Vector3d& tangent, double r,
                         int steps) {
  std::vector<Station> stations;
  for (int i = 0; i < steps; ++i) {
    const double angle = 0.5 * pi * (i + 0.25) / steps;
    stations.push_back({centre + r * std::cos(angle) * outward, tangent, r * std::sin(angle)});
  }
  return stations;
}

std::vector<Station> axis() {
  std::vector<Station> line =
      cap(Vector3d::Zero(), -Vector3d::UnitY(), Vector3d::UnitY(), explorer_tip_radius, 6);
  Vector3d p = Vector3d::Zero();
  double heading = 0.0;
  double along = 0.0;
  const auto direction = [&] { return Vector3d(0.0, std::cos(heading), std::sin(heading)); };
  for (const Stretch& stretch : stretches) {
    const double bend = stretch.turn / stretch.length;
    double rest = stretch.length;
    while (rest > 1e-9) {
      line.push_back({p, direction(), radius()(along) - cut(along)});
      const double pace = std::min({step(along), rest, bend == 0.0 ? 1.0 : 0.35 * mm});
      heading += 0.5 * bend * pace;
      p += pace * direction();
      heading += 0.5 * bend * pace;
      along += pace;
      rest -= pace;
    }
  }
  const double r = radius()(along);
  std::vector<Station> end = cap(p, direction(), direction(), r, 8);
  line.push_back({p, direction(), r});
  line.insert(line.end(), end.rbegin(), end.rend());
  return line;
}

}  // namespace

Model make_explorer() {
  Model model{.name = "explorer",
              .materials = {{.name = "surgical steel",
                             .base_colour = {0.56, 0.56, 0.57},
                             .metallic = 1.0,
                             .roughness = 0.26}},
              .parts = {}};
  std::vector<Station> line = axis();
  // The flat ends of a tube have its plain radius: all but a speck of it is in the stations.
  constexpr double speck = 0.02 * mm;
  for (Station& station : line) station.swell -= speck;
  line.insert(line.begin(), {line.front().p - 1e-3 * mm * line.front().tangent, line.front().tangent, 0.0});
  line.push_back({line.back().p + 1e-3 * mm * line.back().tangent, line.back().tangent, 0.0});
  model.parts.push_back({.name = "explorer",
                         .material = 0,
                         .solid = tube(line, speck, columns, TubeEnd::flat, TubeEnd::flat),
                         .crease = 50 * degree});
  return model;
}

}  // namespace fulcrum::content
