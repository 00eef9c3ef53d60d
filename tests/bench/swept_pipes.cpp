#include "tests/bench/swept_pipes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/content/mesh/tube.h"
#include "tools/content/piping/piping.h"

namespace fulcrum::bench {
namespace {

constexpr double kBendRadii = 3;                          // of the pipe, as the plant's bends
constexpr int kColumns = 64;                              // corners around the circle
constexpr double kBendStep = 2 * std::numbers::pi / 180;  // rad, along a bend
constexpr double kRunStep = 50e-3;                        // m, along a run

SweptPipe swept(const content::PipeLine& line) {
  SweptPipe pipe{line.size.pipe_radius, {}, {}};
  const double bend_radius = kBendRadii * pipe.radius;
  Vec3 at = line.corners.front();
  for (std::size_t i = 1; i < line.corners.size(); ++i) {
    const Vec3& corner = line.corners[i];
    const Vec3 in = (corner - at).normalized();
    const bool last = i + 1 == line.corners.size();
    const Vec3 out = last ? in : Vec3((line.corners[i + 1] - corner).normalized());
    const double angle = std::acos(std::clamp(in.dot(out), -1.0, 1.0));
    const double setback = last ? 0 : bend_radius * std::tan(angle / 2);
    const Vec3 end = corner - setback * in;
    pipe.parts.emplace_back(Run{at, end, i == 1, last});
    if (last) break;
    const Vec3 inward = (out - out.dot(in) * in).normalized();
    pipe.parts.emplace_back(Bend{end + bend_radius * inward, -inward, in, bend_radius, angle});
    at = corner + setback * out;
  }
  for (const Vec3& corner : line.corners) {
    pipe.bounds.extend(Vec3(corner.array() - pipe.radius));
    pipe.bounds.extend(Vec3(corner.array() + pipe.radius));
  }
  return pipe;
}

struct ToPart {
  double distance;  // m
  Vec3 normal;      // (3) unit
};

Vec3 unit(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::UnitX());
}

ToPart to_part(const Run& run, double radius, const Vec3& p) {
  const double length = (run.to - run.from).norm();
  const Vec3 axis = (run.to - run.from) / length;
  const double along = axis.dot(p - run.from);
  const double low = run.open_from ? std::min(along, 0.0) : 0.0;
  const double high = run.open_to ? std::max(along, length) : length;
  const Vec3 from_axis = p - run.from - std::clamp(along, low, high) * axis;
  const double aside = from_axis.norm() - radius;
  double beyond = -length;  // m past the nearer open end
  Vec3 outward = axis;
  if (run.open_from && -along > beyond) {
    beyond = -along;
    outward = -axis;
  }
  if (run.open_to && along - length > beyond) {
    beyond = along - length;
    outward = axis;
  }
  if (aside > 0 && beyond > 0)
    return {std::hypot(aside, beyond), unit(aside * unit(from_axis) + beyond * outward)};
  return aside >= beyond ? ToPart{aside, unit(from_axis)} : ToPart{beyond, outward};
}

ToPart to_part(const Bend& bend, double radius, const Vec3& p) {
  const Vec3 from_centre = p - bend.centre;
  double angle = std::atan2(bend.tangent.dot(from_centre), bend.arm.dot(from_centre));
  if (angle < (bend.angle - 2 * std::numbers::pi) / 2)
    angle += 2 * std::numbers::pi;  // to the nearer end of the bend
  angle = std::clamp(angle, 0.0, bend.angle);
  const Vec3 from_axis =
      from_centre - bend.radius * (std::cos(angle) * bend.arm + std::sin(angle) * bend.tangent);
  return {from_axis.norm() - radius, unit(from_axis)};
}

void add_stations(const Run& run, std::vector<content::Station>& stations) {
  const double length = (run.to - run.from).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kRunStep)));
  for (int i = run.open_from ? 0 : 1; i <= steps; ++i)
    stations.push_back({run.from + (run.to - run.from) * i / steps, (run.to - run.from) / length, 0});
}

void add_stations(const Bend& bend, std::vector<content::Station>& stations) {
  const int steps = std::max(1, static_cast<int>(std::ceil(bend.angle / kBendStep - 1e-9)));
  for (int i = 1; i <= steps; ++i) {
    const double a = bend.angle * i / steps;
    stations.push_back({bend.centre + bend.radius * (std::cos(a) * bend.arm + std::sin(a) * bend.tangent),
                        std::cos(a) * bend.tangent - std::sin(a) * bend.arm, 0});
  }
}

}  // namespace

std::vector<SweptPipe> plant_pipes() {
  std::vector<SweptPipe> pipes;
  for (const content::PipeLine& line : content::pipe_lines()) pipes.push_back(swept(line));
  return pipes;
}

Nearest nearest_pipe(const std::vector<SweptPipe>& pipes, const Vec3& p) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Nearest nearest{kFar, Vec3::UnitX(), 0, kFar};
  for (const SweptPipe& pipe : pipes) {
    const double to_box = pipe.bounds.exteriorDistance(p);
    if (to_box > nearest.distance) {
      nearest.runner_up = std::min(nearest.runner_up, to_box);
      continue;
    }
    ToPart least{kFar, Vec3::UnitX()};
    for (const auto& part : pipe.parts) {
      const ToPart to = std::visit([&](const auto& of) { return to_part(of, pipe.radius, p); }, part);
      if (to.distance < least.distance) least = to;
    }
    if (least.distance < nearest.distance) {
      // On the hollow side of a bend, where the centreline curves around the point.
      const double room = (kBendRadii - 1) * pipe.radius - std::max(least.distance, 0.0);
      nearest = {least.distance, least.normal, room > 0 ? 1 / room : kFar, nearest.distance};
    } else {
      nearest.runner_up = std::min(nearest.runner_up, least.distance);
    }
  }
  return nearest;
}

TriangleMesh mesh_of(const std::vector<SweptPipe>& pipes) {
  constexpr double kHalfColumn = std::numbers::pi / kColumns;
  TriangleMesh mesh;
  for (const SweptPipe& pipe : pipes) {
    std::vector<content::Station> stations;
    for (const auto& part : pipe.parts) std::visit([&](const auto& of) { add_stations(of, stations); }, part);
    const content::Solid solid = content::tube(stations, pipe.radius / (1 - kHalfColumn * kHalfColumn / 3),
                                               kColumns, content::TubeEnd::flat, content::TubeEnd::flat);
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), solid.points.begin(), solid.points.end());
    for (const content::Triangle& t : solid.triangles)
      mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return mesh;
}

}  // namespace fulcrum::bench
