#include "tools/content/piping/spanner_head.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum::content {
namespace {

constexpr int columns = 96;
constexpr int first_column = -frame_across / 2;  // of the opening, counted from the direction of the shank
constexpr int rounding_steps = 4;
constexpr double fit = 0.1 * mm;      // from the nut's flats to the ring's
constexpr double mouth = 0.75 * mm;   // from the points of the hole to the edge of its lead-in cone
constexpr double barrel = 0.25 * mm;  // how far the outer wall bulges in its middle

static_assert(frame_across == columns / 4, "the opening takes a quarter of the ring");

// Two hexagons, a twelfth of a turn apart: the distance from the axis to the wall of the hole.
double hole_radius(double across_flats, double angle) {
  const double sector = pi / 6.0;
  const double from_point = angle - sector * std::floor(angle / sector + 0.5);
  return (0.5 * across_flats + fit) / math::cos(sector - std::abs(from_point));
}

struct ProfilePoint {
  double r;  // m
  double z;  // m
};

// The ring's section at an angle: up the outer wall, inwards over the top, down the hole, back below.
std::vector<ProfilePoint> profile(const RingHead& head, double angle) {
  const double wall = opening_half_height(head);
  const double top = 0.5 * head.height;
  const double hole = hole_radius(head.across_flats, angle);
  const double cone = hole_radius(head.across_flats, 0.0) + mouth;
  std::vector<ProfilePoint> points;
  for (int j = 0; j <= frame_up; ++j) {
    const double u = -1.0 + 2.0 * j / frame_up;
    points.push_back({head.radius - barrel * u * u, wall * u});
  }
  std::vector<ProfilePoint> over;
  for (int j = 1; j <= rounding_steps; ++j) {
    const double a = 0.5 * pi * j / rounding_steps;
    over.push_back(
        {head.radius - barrel - head.rounding * (1.0 - math::cos(a)), wall + head.rounding * math::sin(a)});
  }
  over.push_back({cone, top});
  over.push_back({hole, top - (cone - hole)});
  points.insert(points.end(), over.begin(), over.end());
  points.push_back({hole, 0.0});
  for (auto at = over.rbegin(); at != over.rend(); ++at) points.push_back({at->r, -at->z});
  return points;
}

class RingBuilder {
public:
  RingBuilder(Solid* solid, const RingHead& head, const Eigen::Vector3d& centre, bool turned)
      : solid_(*solid), rows_(static_cast<int>(profile(head, 0.0).size())), first_(solid->points.size()) {
    const double side = turned ? -1.0 : 1.0;
    for (int i = 0; i < columns; ++i) {
      const double angle = 2.0 * pi * i / columns;
      for (const ProfilePoint& at : profile(head, angle)) {
        solid_.add_point(
            centre + Eigen::Vector3d(side * at.r * math::cos(angle), side * at.r * math::sin(angle), at.z));
      }
    }
  }

  std::uint32_t at(int column, int row) const {
    const int i = (column % columns + columns) % columns;
    const int j = row % rows_;
    return static_cast<std::uint32_t>(first_) + static_cast<std::uint32_t>(i * rows_ + j);
  }

  void add_faces() {
    for (int i = first_column; i < first_column + columns; ++i) {
      for (int j = 0; j < rows_; ++j) {
        const bool in_opening = i < first_column + frame_across && j < frame_up;
        if (!in_opening) solid_.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }

  std::vector<std::uint32_t> opening(bool turned) const {
    const int sense = turned ? -1 : 1;
    const int start = turned ? -first_column : first_column;
    const int end = -start;
    std::vector<std::uint32_t> points;
    for (int k = 0; k < frame_across; ++k) points.push_back(at(start + sense * k, 0));
    for (int k = 0; k < frame_up; ++k) points.push_back(at(end, k));
    for (int k = 0; k < frame_across; ++k) points.push_back(at(end - sense * k, frame_up));
    for (int k = 0; k < frame_up; ++k) points.push_back(at(start, frame_up - k));
    return points;
  }

private:
  Solid& solid_;
  int rows_;
  std::size_t first_;
};

}  // namespace

std::vector<std::uint32_t> add_ring_head(Solid* solid, const RingHead& head, const Eigen::Vector3d& centre,
                                         bool turned) {
  RingBuilder ring(solid, head, centre, turned);
  ring.add_faces();
  return ring.opening(turned);
}

}  // namespace fulcrum::content
