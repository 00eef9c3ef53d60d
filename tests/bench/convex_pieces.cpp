#include "tests/bench/convex_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/content/piping/spanner.h"

namespace fulcrum::bench {
namespace {

using Design = content::SpannerDesign;

struct HalfSpace {
  Vec3 normal;    // (3) unit, out of what is kept
  double offset;  // m
};

using Polygon = std::vector<Vec3>;

Polygon clipped(const Polygon& polygon, const HalfSpace& to) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double above_a = to.normal.dot(a) - to.offset, above_b = to.normal.dot(b) - to.offset;
    if (above_a <= 0) kept.push_back(a);
    if ((above_a < 0 && above_b > 0) || (above_a > 0 && above_b < 0))
      kept.push_back(a + above_a / (above_a - above_b) * (b - a));
  }
  return kept;
}

// Corners of the surface within the half-spaces.
HullPoints cut(const TriangleMesh& mesh, const std::vector<HalfSpace>& within) {
  HullPoints points;
  for (const Triangle& t : mesh.triangles) {
    Polygon polygon{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    for (const HalfSpace& half : within) polygon = clipped(polygon, half);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// A plane through `p` in the tool's frame, which is the drawing's, moved.
HalfSpace below(const Vec3& normal, const Vec3& p) {
  return {normal, normal.dot(p)};
}

// towards: +1 where the ring's shank leaves along +x.
void add_ring(const TriangleMesh& mesh, const content::RingHead& head, const Vec3& centre, double towards,
              std::vector<HullPoints>& pieces) {
  constexpr int kSectors = 12;
  constexpr double kSector = 2 * std::numbers::pi / kSectors;
  // A sector goes past the outer wall a little, where the neck's fillets meet it.
  constexpr double kInto = 1.05;
  for (int i = 0; i < kSectors; ++i) {
    const auto at = [&](double angle) { return Vec3(towards * std::cos(angle), std::sin(angle), 0); };
    const double start = kSector * i;
    const Vec3 outward = at(start + kSector / 2);
    pieces.push_back(cut(mesh, {below(-at(start + std::numbers::pi / 2), centre),
                                below(at(start + kSector + std::numbers::pi / 2), centre),
                                below(outward, centre + kInto * head.radius * outward)}));
  }
}

// Slabs across the shank, from where one ring's hole is past to where the other's begins.
void add_shank(const TriangleMesh& mesh, const Vec3& middle, std::vector<HullPoints>& pieces) {
  const auto hole = [](const content::RingHead& head) { return 0.88 * head.radius; };
  const double a = -Design::half_length + hole(Design::small), b = Design::half_length - hole(Design::large);
  const double inner = Design::half_length - Design::crank_end;
  std::vector<double> at;
  for (const double step : {0.0, 0.1, 0.25, 0.5, 0.75}) at.push_back(a + step * (-inner - a));
  at.insert(at.end(), {-inner, 0.0, inner});
  for (const double step : {0.25, 0.5, 0.75, 0.9, 1.0}) at.push_back(inner + step * (b - inner));
  const Vec3 x = Vec3::UnitX();
  for (std::size_t i = 1; i < at.size(); ++i)
    pieces.push_back(cut(mesh, {below(-x, middle + at[i - 1] * x), below(x, middle + at[i] * x)}));
}

void add_bend(const Bend& bend, double radius, std::vector<HullPoints>& pieces) {
  constexpr int kColumns = 48;
  constexpr double kPiece = 22.5 * std::numbers::pi / 180;
  constexpr int kSections = 9;  // of a piece: its ends and its middle
  const double drawn = radius / (1 - std::pow(std::numbers::pi / kColumns, 2) / 3);
  const Vec3 aside = bend.arm.cross(bend.tangent);
  const int count = static_cast<int>(std::ceil(bend.angle / kPiece - 1e-9));
  for (int piece = 0; piece < count; ++piece) {
    HullPoints& points = pieces.emplace_back();
    for (int section = 0; section < kSections; ++section) {
      const double a = bend.angle * (piece + section / (kSections - 1.0)) / count;
      const Vec3 out = std::cos(a) * bend.arm + std::sin(a) * bend.tangent;
      for (int k = 0; k < kColumns; ++k) {
        const double b = 2 * std::numbers::pi * k / kColumns;
        points.push_back(bend.centre + (bend.radius + drawn * std::cos(b)) * out +
                         drawn * std::sin(b) * aside);
      }
    }
  }
}

}  // namespace

std::vector<HullPoints> spanner_pieces(const TriangleMesh& spanner_T) {
  const Vec3 middle = -content::spanner_centre_of_mass();
  const Vec3 x = Vec3::UnitX();
  std::vector<HullPoints> pieces;
  add_ring(spanner_T, Design::small, middle - Design::half_length * x, 1, pieces);
  add_ring(spanner_T, Design::large, middle + Design::half_length * x, -1, pieces);
  add_shank(spanner_T, middle, pieces);
  return pieces;
}

PipePieces pipe_pieces(const std::vector<SweptPipe>& pipes) {
  PipePieces pieces;
  for (const SweptPipe& pipe : pipes) {
    for (const auto& part : pipe.parts)
      if (const auto* run = std::get_if<Run>(&part))
        pieces.runs.push_back({run->from, run->to, pipe.radius});
      else
        add_bend(std::get<Bend>(part), pipe.radius, pieces.bends);
  }
  return pieces;
}

}  // namespace fulcrum::bench
