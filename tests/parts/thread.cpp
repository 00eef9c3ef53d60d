#include "tests/parts/thread.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum::parts {
namespace {

// ISO 965-1, in micrometres of millimetres: the deviation g, and the tolerances of the pitch diameter.
double deviation_g(double pitch) {
  return 1e-6 * (15 + 11 * pitch * 1e3);
}
double tolerance_6_bolt(const MetricThread& t) {
  return 1e-6 * 90 * std::pow(t.pitch * 1e3, 0.4) * std::pow(t.diameter * 1e3, 0.1);
}
double tolerance_6_nut(const MetricThread& t) {
  return 1.32 * tolerance_6_bolt(t);
}

// A thread's surface as corners that run along helices: per pitch four of them, at these heights and radii
// where the angle is 0.
struct Profile {
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
Profile profile(const MetricThread& t, double offset, double crest_cut, double root_cut) {
  const double p = t.pitch, h = std::numbers::sqrt3 / 2 * p;
  const double major = t.diameter / 2, minor = major - 5.0 / 8 * h;
  const double slope = 1 / std::numbers::sqrt3;  // m along z for a metre of radius
  // Flanks of the basic profile: crest from -p/16 to p/16 at the major radius.
  const double crest = major + offset - crest_cut, root = minor + offset - root_cut;
  const double half_crest = p / 16 + (major + offset - crest) * slope;
  const double half_root = p / 8 - (minor + offset - root) * slope;
  return {p, {-half_crest, half_crest, p / 2 - half_root, p / 2 + half_root}, {crest, crest, root, root}};
}

// A column of the surface at one angle: from the bottom to the top.
struct Node {
  int corner;  // kBottom, kTop, or which
  std::uint32_t vertex;
  double z;
};
constexpr int kBottom = -1000000, kTop = 1000000;

struct Surface {
  TriangleMesh mesh;
  std::vector<std::uint32_t> bottom, top;  // (sectors) rims
};

// outward: of the solid inside it, a bolt; else of one around it.
Surface helical(const Profile& profile, double length, int sectors, bool outward) {
  Surface surface;
  std::vector<std::vector<Node>> columns;
  for (int i = 0; i < sectors; ++i) {
    const double part = static_cast<double>(i) / sectors, angle = 2 * std::numbers::pi * part;
    const double rise = profile.pitch * part;
    int first = 4 * static_cast<int>(std::floor(-rise / profile.pitch)) - 8;
    while (profile.height(first) + rise <= 1e-9) ++first;
    int last = first;
    while (profile.height(last) + rise < length - 1e-9) ++last;
    const auto radius_at = [&](double z, int above) {  // between corners above - 1 and above
      const double a = profile.height(above - 1) + rise, b = profile.height(above) + rise;
      return std::lerp(profile.radius(above - 1), profile.radius(above), (z - a) / (b - a));
    };
    std::vector<Node> column;
    const auto add = [&](int corner, double r, double z) {
      column.push_back({corner, static_cast<std::uint32_t>(surface.mesh.vertices.size()), z});
      surface.mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    };
    add(kBottom, radius_at(0, first), 0);
    for (int corner = first; corner < last; ++corner)
      add(corner, profile.radius(corner), profile.height(corner) + rise);
    add(kTop, radius_at(length, last), length);
    surface.bottom.push_back(column.front().vertex);
    surface.top.push_back(column.back().vertex);
    columns.push_back(std::move(column));
  }
  for (int i = 0; i < sectors; ++i) {
    const std::vector<Node>& left = columns[static_cast<std::size_t>(i)];
    std::vector<Node> right = columns[static_cast<std::size_t>((i + 1) % sectors)];
    // Once around, a corner has risen to where the fourth one after it began.
    if (i + 1 == sectors)
      for (Node& node : right)
        if (node.corner != kBottom && node.corner != kTop) node.corner -= 4;
    std::size_t l = 0, r = 0;
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (outward)
        surface.mesh.triangles.push_back({a, b, c});
      else
        surface.mesh.triangles.push_back({a, c, b});
    };
    while (l + 1 < left.size() || r + 1 < right.size()) {
      const bool both = l + 1 < left.size() && r + 1 < right.size();
      const bool up_left = r + 1 == right.size() || (both && left[l + 1].corner <= right[r + 1].corner);
      const bool up_right = l + 1 == left.size() || (both && right[r + 1].corner <= left[l + 1].corner);
      if (up_right) {
        triangle(left[l].vertex, right[r].vertex, right[r + 1].vertex);
        ++r;
      }
      if (up_left) {
        triangle(left[l].vertex, right[r].vertex, left[l + 1].vertex);
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

TriangleMesh bolt(const MetricThread& t, double length, int sectors) {
  const double off = -(deviation_g(t.pitch) + tolerance_6_bolt(t) / 2) / 2,
               h = std::numbers::sqrt3 / 2 * t.pitch;
  Surface surface = helical(profile(t, off, 0.02 * t.pitch, h / 8), length, sectors, true);
  TriangleMesh& mesh = surface.mesh;
  const auto n = static_cast<std::size_t>(sectors);
  for (const bool top : {false, true}) {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, top ? length : 0);
    const std::vector<std::uint32_t>& rim = top ? surface.top : surface.bottom;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t a = rim[i], b = rim[(i + 1) % n];
      mesh.triangles.push_back(top ? Triangle{a, b, middle} : Triangle{b, a, middle});
    }
  }
  return mesh;
}

TriangleMesh nut(const MetricThread& t, double height, double across_flats, int sectors) {
  const double off = tolerance_6_nut(t) / 4, h = std::numbers::sqrt3 / 2 * t.pitch;
  Surface surface = helical(profile(t, off, -h / 16, -0.02 * t.pitch), height, sectors, false);
  TriangleMesh& mesh = surface.mesh;
  const auto n = static_cast<std::uint32_t>(sectors);
  const auto outer = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const double z : {0.0, height})
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, sixth = std::numbers::pi / 3;
      const double off_flat = std::fmod(angle, sixth) - sixth / 2;
      const double r = across_flats / 2 / std::cos(off_flat);
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n, a = outer + i, b = outer + j, c = a + n, d = b + n;
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({a, d, c});
    const std::uint32_t bi = surface.bottom[i], bj = surface.bottom[j], ti = surface.top[i],
                        tj = surface.top[j];
    mesh.triangles.push_back({bi, b, a});
    mesh.triangles.push_back({bi, bj, b});
    mesh.triangles.push_back({ti, c, d});
    mesh.triangles.push_back({ti, d, tj});
  }
  return mesh;
}

}  // namespace fulcrum::parts
