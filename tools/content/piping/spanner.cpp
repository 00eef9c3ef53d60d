#include "tools/content/piping/spanner.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/mass.h"
#include "tools/content/mesh/steel.h"
#include "tools/content/piping/spanner_head.h"

namespace fulcrum::content {
namespace {

using Design = SpannerDesign;

constexpr double edge_radius = 1.5 * mm;
constexpr double panel_half_width = 3.6 * mm;
constexpr double panel_depth = 0.9 * mm;
constexpr double panel_wall = 0.7 * mm;
constexpr double panel_half_length = 36.0 * mm;
constexpr double panel_end_radius = 4.0 * mm;
constexpr double brush_size = 34.0 * mm;  // of the picture of its steel

double smooth_step(double u) {
  const double t = std::clamp(u, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Where a frame's point lies on the frame: across -12..12 on the lower and upper side, up -4..4 elsewhere.
struct FrameIndex {
  int across = 0;
  int up = 0;
};

FrameIndex frame_index(int k) {
  constexpr int half_across = frame_across / 2;
  constexpr int half_up = frame_up / 2;
  if (k < frame_across) return {k - half_across, -half_up};
  k -= frame_across;
  if (k < frame_up) return {half_across, k - half_up};
  k -= frame_up;
  if (k < frame_across) return {half_across - k, half_up};
  k -= frame_across;
  return {-half_across, half_up - k};
}

struct ShankSection {
  double half_width;
  double half_thickness;
  double panel_half_width;
  double panel_depth;
};

// Sections stand upright while the crank climbs: their height grows so that the shank keeps its thickness.
double upright_stretch(double from_ring_axis) {
  constexpr double step = 0.1 * mm;
  const double rise = crank_height(from_ring_axis + step) - crank_height(from_ring_axis - step);
  return math::hypot(1.0, rise / (2.0 * step));
}

// Offset from the section's middle, (y, z).
Eigen::Vector2d shank_outline(const FrameIndex& at, const ShankSection& s) {
  constexpr int half_across = frame_across / 2;
  constexpr int half_up = frame_up / 2;
  constexpr double arc_step = 45.0 * degree / 3.0;
  const double y_sign = at.across < 0 ? -1.0 : 1.0;
  const double z_sign = at.up < 0 ? -1.0 : 1.0;
  const int q = std::abs(at.across);
  const int v = std::abs(at.up);
  const double y_arc = s.half_width - edge_radius;
  const double z_arc = s.half_thickness - edge_radius;
  if (q == half_across && v < half_up) {
    if (v <= 2) return {y_sign * s.half_width, z_sign * z_arc * v / 2.0};
    const double a = 22.5 * degree * (v - 2);
    return {y_sign * (y_arc + edge_radius * math::cos(a)), z_sign * (z_arc + edge_radius * math::sin(a))};
  }
  if (q >= 9) {
    const double a = arc_step * (q - 9);
    return {y_sign * (y_arc + edge_radius * math::sin(a)), z_sign * (z_arc + edge_radius * math::cos(a))};
  }
  const double floor = s.half_thickness - s.panel_depth;
  if (q <= 6) return {y_sign * s.panel_half_width * q / 6.0, z_sign * floor};
  const double wall = 0.5 * (q - 6);
  return {y_sign * (s.panel_half_width + panel_wall * wall), z_sign * (floor + s.panel_depth * wall)};
}

// The neck between a ring and the full section of the shank, in the ring's own frame (+x towards the
// shank). In plan its sides are arcs, tangent to the ring and to the shank.
class Neck {
public:
  Neck(const RingHead& head, double half_width) : head_(head), half_width_(half_width) {
    const double s = math::sin(opening_half_angle);
    fillet_ = (head.radius * s - half_width) / (1.0 - s);
    end_ = (head.radius + fillet_) * math::cos(opening_half_angle);
  }

  double end() const { return end_; }

  // u from 0 at the ring's wall to 1 at the end of the fillets.
  Eigen::Vector3d point(const FrameIndex& at, double u, const Eigen::Vector3d& on_ring) const {
    const Eigen::Vector3d drawn = formula(at, u);
    const double fade = (1.0 - u) * (1.0 - u);
    return drawn + fade * (on_ring - formula(at, 0.0));
  }

private:
  Eigen::Vector3d formula(const FrameIndex& at, double u) const {
    constexpr double half_across = frame_across / 2;
    constexpr double half_up = frame_up / 2;
    const double a = 1.25 * pi + u * 0.25 * pi;
    const double x_edge = end_ + fillet_ * math::cos(a);
    const double y_edge = half_width_ + fillet_ + fillet_ * math::sin(a);
    const double x_edge_start = head_.radius * math::cos(opening_half_angle);
    const double t = (x_edge - x_edge_start) / (end_ - x_edge_start);

    const double angle = opening_half_angle * at.across / half_across;
    const double x = (1.0 - t) * head_.radius * math::cos(angle) + t * end_;
    const double z_half = half_thickness(t * (end_ - head_.radius));
    const Eigen::Vector2d block(y_edge * math::sin(angle) / math::sin(opening_half_angle),
                                z_half * at.up / half_up);
    const Eigen::Vector2d shank = shank_outline(at, {y_edge, z_half, panel_half_width, 0.0});
    const double blend = smooth_step(t);
    const Eigen::Vector2d yz = (1.0 - blend) * block + blend * shank;
    const double stretch = 1.0 + blend * (upright_stretch(x) - 1.0);
    return {x, yz.x(), stretch * yz.y() + crank_height(x)};
  }

  // A small fillet where the neck's faces leave the ring's wall.
  double half_thickness(double from_wall) const {
    const double radius = opening_half_height(head_) - Design::shank_half_thickness;
    if (from_wall >= radius) return Design::shank_half_thickness;
    const double d = radius - std::max(0.0, from_wall);
    return Design::shank_half_thickness + radius - std::sqrt(radius * radius - d * d);
  }

  RingHead head_;
  double half_width_;
  double fillet_ = 0.0;
  double end_ = 0.0;
};

// Full section of the shank at a place along the drawing's x axis.
Eigen::Vector3d shank_point(const FrameIndex& at, double x, double depth) {
  const double from_ring = Design::half_length - std::abs(x);
  const double into_end =
      std::clamp((panel_end_radius - (panel_half_length - std::abs(x))) / panel_end_radius, 0.0, 1.0);
  const double narrowed = 0.3 + 0.7 * std::sqrt(1.0 - into_end * into_end);
  const Eigen::Vector2d yz = shank_outline(
      at, {Design::shank_half_width, Design::shank_half_thickness, panel_half_width * narrowed, depth});
  return {x, yz.x(), crank_height(from_ring) + yz.y() * upright_stretch(from_ring)};
}

struct ShankStation {
  double x;      // m
  double depth;  // m, of the panel
};

std::vector<ShankStation> shank_stations(double from, double to) {
  constexpr int crank_steps = 16;
  constexpr int end_steps = 5;
  constexpr int panel_steps = 16;
  const double crank_inner = Design::half_length - Design::crank_end;
  const double ramp_end = panel_half_length + panel_wall;
  std::vector<ShankStation> result;
  for (int i = 1; i <= crank_steps; ++i)
    result.push_back({from + (-crank_inner - from) * i / crank_steps, 0.0});
  result.push_back({-ramp_end, 0.0});
  std::vector<double> panel;
  for (int i = 0; i < end_steps; ++i)
    panel.push_back(-panel_half_length + panel_end_radius * (1.0 - math::cos(0.5 * pi * i / end_steps)));
  const double inner = panel_half_length - panel_end_radius;
  for (int i = 0; i <= panel_steps; ++i) panel.push_back(-inner + 2.0 * inner * i / panel_steps);
  for (int i = end_steps - 1; i >= 0; --i) panel.push_back(-panel[static_cast<std::size_t>(i)]);
  for (const double x : panel) result.push_back({x, panel_depth});
  result.push_back({ramp_end, 0.0});
  for (int i = 0; i < crank_steps; ++i)
    result.push_back({crank_inner + (to - crank_inner) * i / crank_steps, 0.0});
  return result;
}

class ShankBuilder {
public:
  ShankBuilder(Solid* solid, std::vector<std::uint32_t> start)
      : solid_(*solid), previous_(std::move(start)) {}

  template <typename PointAt>
  void extend(const PointAt& point_at) {
    std::vector<std::uint32_t> frame;
    for (int k = 0; k < frame_points; ++k) frame.push_back(solid_.add_point(point_at(k)));
    join(frame);
  }

  void join(const std::vector<std::uint32_t>& frame) {
    const std::size_t n = frame.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      solid_.add_quad(previous_[k], previous_[next], frame[next], frame[k]);
    }
    previous_ = frame;
  }

private:
  Solid& solid_;
  std::vector<std::uint32_t> previous_;
};

}  // namespace

double crank_height(double from_ring_axis) {
  return Design::offset *
         smooth_step((from_ring_axis - Design::crank_start) / (Design::crank_end - Design::crank_start));
}

Solid spanner_solid() {
  constexpr int neck_steps = 9;
  const Eigen::Vector3d small_centre(-Design::half_length, 0.0, 0.0);
  const Eigen::Vector3d large_centre(Design::half_length, 0.0, 0.0);
  Solid solid;
  const std::vector<std::uint32_t> small_opening = add_ring_head(&solid, Design::small, small_centre, false);
  const std::vector<std::uint32_t> large_opening = add_ring_head(&solid, Design::large, large_centre, true);
  const Neck small_neck(Design::small, Design::shank_half_width);
  const Neck large_neck(Design::large, Design::shank_half_width);

  ShankBuilder shank(&solid, small_opening);
  for (int i = 1; i <= neck_steps; ++i) {
    shank.extend([&](int k) -> Eigen::Vector3d {
      const Eigen::Vector3d on_ring = solid.points[small_opening[static_cast<std::size_t>(k)]] - small_centre;
      return small_centre + small_neck.point(frame_index(k), static_cast<double>(i) / neck_steps, on_ring);
    });
  }
  const double from = small_centre.x() + small_neck.end();
  const double to = large_centre.x() - large_neck.end();
  for (const ShankStation& station : shank_stations(from, to))
    shank.extend([&](int k) { return shank_point(frame_index(k), station.x, station.depth); });
  // The large ring's own frame is turned half round about z.
  const Eigen::Vector3d half_turn(-1.0, -1.0, 1.0);
  for (int i = neck_steps; i >= 1; --i) {
    shank.extend([&](int k) -> Eigen::Vector3d {
      FrameIndex at = frame_index(k);
      at.across = -at.across;
      const Eigen::Vector3d on_ring =
          half_turn.cwiseProduct(solid.points[large_opening[static_cast<std::size_t>(k)]] - large_centre);
      return large_centre +
             half_turn.cwiseProduct(large_neck.point(at, static_cast<double>(i) / neck_steps, on_ring));
    });
  }
  shank.join(large_opening);
  return solid;
}

Eigen::Vector3d spanner_centre_of_mass() {
  return mass_properties(spanner_solid(), steel_density).centre;
}

Model make_spanner() {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = -spanner_centre_of_mass();
  Model model;
  model.name = "spanner";
  model.materials.push_back(brushed("chrome vanadium", {0.72, 0.71, 0.69}, 0.24));
  // The walls of a twelve-point hole meet at 30 degrees between its points.
  constexpr double crease = 27.0 * degree;
  const Solid solid = transformed(spanner_solid(), X);
  model.parts.push_back({.name = "spanner/19x17",
                         .material = 0,
                         .solid = solid,
                         .crease = crease,
                         .coat = worn(solid),
                         .uv = unwrapped_box(solid, brush_size)});
  return model;
}

}  // namespace fulcrum::content
