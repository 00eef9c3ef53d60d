#include "tools/content/mesh/metric_thread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "haptics/math/functions.h"
#include "tools/content/mesh/hexagon.h"

namespace fulcrum::content {
namespace {

constexpr double root_three = 1.7320508075688772;
constexpr double same = 1e-6;  // m: heights that differ by less are one

// ISO 965-1, in micrometres of millimetres: the deviation g, and the tolerances of the pitch diameter.
double deviation_g(double pitch) {
  return 1e-6 * (15 + 11 * pitch * 1e3);
}
double tolerance_6_bolt(const MetricThread& t) {
  return 1e-6 * 90 * math::pow(t.pitch * 1e3, 0.4) * math::pow(t.diameter * 1e3, 0.1);
}
double tolerance_6_nut(const MetricThread& t) {
  return 1.32 * tolerance_6_bolt(t);
}

// A thread's surface as corners that run along helices: per pitch four of them, at these heights and radii
// where the angle is 0.
struct ThreadProfile {
  double pitch;
  double z[4], r[4];

  double height(int corner) const {
    const int turn = corner >= 0 ? corner / 4 : -((3 - corner) / 4);
    return z[corner - 4 * turn] + pitch * turn;
  }
  double radius(int corner) const { return r[((corner % 4) + 4) % 4]; }
};

// Crest and root are narrower and wider than the basic profile's by what the pitch diameter is off: outward
// by `offset` (m, radial).
ThreadProfile thread_profile(const MetricThread& t, double offset, double crest_cut, double root_cut) {
  const double p = t.pitch, h = root_three / 2 * p;
  const double major = t.diameter / 2, minor = major - 5.0 / 8 * h;
  const double slope = 1 / root_three;  // m along z for a metre of radius
  // Flanks of the basic profile: crest from -p/16 to p/16 at the major radius.
  const double crest = major + offset - crest_cut, root = minor + offset - root_cut;
  const double half_crest = p / 16 + (major + offset - crest) * slope;
  const double half_root = p / 8 - (minor + offset - root) * slope;
  return {p, {-half_crest, half_crest, p / 2 - half_root, p / 2 + half_root}, {crest, crest, root, root}};
}

// A cone about z that cuts a thread off where it begins: its radius at an end's height, and how much that
// grows for a metre away from the end.
struct EndCone {
  double z, radius, growth;
  double at(double height) const { return radius + growth * std::abs(height - z); }
};

struct Node {
  double z, r;
};

// What is left of a column of the thread, at one angle and from bottom to top, between the cones: a bolt's
// stays inside them, a nut's outside.
std::vector<Node> cut(const std::vector<Node>& thread, const std::vector<EndCone>& cones, bool inside) {
  std::vector<Node> column = thread;
  for (const EndCone& cone : cones) {
    const auto beyond = [&](const Node& node) {  // m, by how much the cone takes off
      return inside ? node.r - cone.at(node.z) : cone.at(node.z) - node.r;
    };
    std::vector<Node> left;
    const auto add = [&](double z, double r) {
      if (left.empty() || z - left.back().z > same) left.push_back({z, r});
    };
    const double top = column.back().z;
    for (std::size_t i = 0; i < column.size(); ++i) {
      const bool end = i == 0 || i + 1 == column.size();
      const double off = beyond(column[i]);
      if (off <= 0)
        add(column[i].z, column[i].r);
      else if (end)
        add(column[i].z, cone.at(column[i].z));
      if (i + 1 == column.size()) break;
      const double next = beyond(column[i + 1]);
      if ((off > 0) == (next > 0)) continue;
      const double part = off / (off - next);
      const double z = std::lerp(column[i].z, column[i + 1].z, part);
      if (top - z > same) add(z, cone.at(z));
    }
    column = std::move(left);
  }
  return column;
}

// The thread's own column where it has risen by `rise`, from z = 0 to length.
std::vector<Node> thread_column(const ThreadProfile& profile, double rise, double length) {
  int corner = 4 * static_cast<int>(std::floor(-rise / profile.pitch)) - 8;
  while (profile.height(corner) + rise <= same) ++corner;
  const auto radius_at = [&](double z) {  // before that corner
    const double a = profile.height(corner - 1) + rise, b = profile.height(corner) + rise;
    return std::lerp(profile.radius(corner - 1), profile.radius(corner), (z - a) / (b - a));
  };
  std::vector<Node> column{{0.0, radius_at(0.0)}};
  for (; profile.height(corner) + rise < length - same; ++corner)
    column.push_back({profile.height(corner) + rise, profile.radius(corner)});
  column.push_back({length, radius_at(length)});
  return column;
}

struct ThreadSurface {
  Solid solid;
  std::vector<std::uint32_t> bottom, top;  // (sectors) rims
};

// outward: of the solid inside it, a bolt; else of one around it.
ThreadSurface threaded(const ThreadProfile& profile, double lead, double length,
                       const std::vector<EndCone>& cones, int sectors, bool outward) {
  struct Corner {
    double z, key;  // key: its height on the helix that it belongs to; corners of one helix have the same
    std::uint32_t point;
  };
  ThreadSurface surface;
  std::vector<std::vector<Corner>> columns;
  for (int i = 0; i < sectors; ++i) {
    const double angle = 2.0 * pi * i / sectors, rise = lead * i / sectors;
    std::vector<Corner>& column = columns.emplace_back();
    for (const Node& node : cut(thread_column(profile, rise, length), cones, outward))
      column.push_back(
          {node.z, node.z - rise,
           surface.solid.add_point({node.r * math::cos(angle), node.r * math::sin(angle), node.z})});
    column.front().key = -std::numeric_limits<double>::infinity();
    column.back().key = std::numeric_limits<double>::infinity();
    surface.bottom.push_back(column.front().point);
    surface.top.push_back(column.back().point);
  }
  for (int i = 0; i < sectors; ++i) {
    const std::vector<Corner>& left = columns[static_cast<std::size_t>(i)];
    std::vector<Corner> right = columns[static_cast<std::size_t>((i + 1) % sectors)];
    // Once around, a helix has risen by the lead.
    if (i + 1 == sectors)
      for (Corner& corner : right) corner.key -= lead;
    std::size_t l = 0, r = 0;
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (outward)
        surface.solid.add_triangle(a, b, c);
      else
        surface.solid.add_triangle(a, c, b);
    };
    while (l + 1 < left.size() || r + 1 < right.size()) {
      const bool both = l + 1 < left.size() && r + 1 < right.size();
      const double ahead = both ? left[l + 1].key - right[r + 1].key : 0.0;
      const bool one_helix = both && !(std::abs(ahead) > same);
      const bool up_left = r + 1 == right.size() || (both && (one_helix || ahead < 0));
      const bool up_right = l + 1 == left.size() || (both && (one_helix || ahead > 0));
      if (up_right) {
        triangle(left[l].point, right[r].point, right[r + 1].point);
        ++r;
      }
      if (up_left) {
        triangle(left[l].point, right[r].point, left[l + 1].point);
        ++l;
      }
    }
  }
  return surface;
}

}  // namespace

double thread_clearance(const MetricThread& t) {
  return (deviation_g(t.pitch) + tolerance_6_bolt(t) / 2 + tolerance_6_nut(t) / 2) / 2;
}

Solid threaded_rod(const MetricThread& t, double length, LeadIn lead_in, int sectors) {
  const double off = -(deviation_g(t.pitch) + tolerance_6_bolt(t) / 2) / 2, h = root_three / 2 * t.pitch;
  const ThreadProfile profile = thread_profile(t, off, 0.02 * t.pitch, h / 8);
  std::vector<EndCone> cones;
  if (lead_in == LeadIn::chamfered) cones.push_back({length, profile.r[2] - 0.1 * t.pitch, 1.0});
  ThreadSurface surface = threaded(profile, t.lead(), length, cones, sectors, true);
  Solid& solid = surface.solid;
  const auto n = static_cast<std::size_t>(sectors);
  for (const bool top : {false, true}) {
    const std::uint32_t middle = solid.add_point({0.0, 0.0, top ? length : 0.0});
    const std::vector<std::uint32_t>& rim = top ? surface.top : surface.bottom;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t a = rim[i], b = rim[(i + 1) % n];
      if (top)
        solid.add_triangle(a, b, middle);
      else
        solid.add_triangle(b, a, middle);
    }
  }
  return solid;
}

Solid threaded_nut(const MetricThread& t, double height, double across_flats, LeadIn lead_in, int sectors) {
  const double off = tolerance_6_nut(t) / 4, h = root_three / 2 * t.pitch;
  const ThreadProfile profile = thread_profile(t, off, -h / 16, -0.02 * t.pitch);
  std::vector<EndCone> cones;
  if (lead_in == LeadIn::chamfered) {
    const double mouth = 1.08 * t.diameter / 2;  // ISO 4032, d_a: 1 to 1.08 times the thread
    cones = {{0.0, mouth, -root_three}, {height, mouth, -root_three}};
  }
  ThreadSurface surface = threaded(profile, t.lead(), height, cones, sectors, false);
  Solid& solid = surface.solid;
  const auto n = static_cast<std::uint32_t>(sectors);
  const auto outer = static_cast<std::uint32_t>(solid.points.size());
  for (const Section& section :
       {circle(flat_radius(across_flats), 0.0, sectors), chamfered_hexagon(across_flats, 0.0, -1.0, sectors),
        chamfered_hexagon(across_flats, height, 1.0, sectors),
        circle(flat_radius(across_flats), height, sectors)})
    for (const Eigen::Vector3d& p : section) solid.add_point(p);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    solid.add_quad(surface.bottom[i], surface.bottom[j], outer + j, outer + i);
    for (std::uint32_t ring = 0; ring < 3; ++ring) {
      const std::uint32_t lower = outer + ring * n, upper = lower + n;
      solid.add_quad(lower + i, lower + j, upper + j, upper + i);
    }
    solid.add_quad(outer + 3 * n + i, outer + 3 * n + j, surface.top[j], surface.top[i]);
  }
  return solid;
}

}  // namespace fulcrum::content
