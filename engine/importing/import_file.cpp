#include "engine/importing/import_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/importing/simplify.h"
#include "haptics/bake/solid.h"
#include "haptics/bake/triangle_tree.h"

namespace fulcrum::importing {
namespace {

constexpr double kLargest = 50, kSmallest = 1e-3;  // m across: more or less was hardly meant
// Of the simplifier's target, until the tolerance is held as it is measured.
constexpr int kTries = 10;
constexpr double kFiner = 0.65;

Box3 box_of(const Model& model) {
  Box3 box;
  for (const ModelPart& part : model.parts)
    for (const Vec3& p : part.positions) box.extend(p);
  return box;
}

std::size_t count_triangles(const Model& model) {
  std::size_t corners = 0;
  for (const ModelPart& part : model.parts) corners += part.indices.size();
  return corners / 3;
}

std::size_t count_thin(const TriangleMesh& mesh) {
  return static_cast<std::size_t>(std::ranges::count_if(
      mesh.triangles,
      [&](const Triangle& t) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        return !((b - a).cross(c - a).norm() > kThin * longest);
      }));
}

// From one to the surface of the other: m, the largest, over corners, middles of edges and middles of
// triangles.
double farthest(const TriangleMesh& from, const TriangleMesh& to) {
  Solid surface;
  surface.mesh = to;
  SolidComponent& all = surface.components.emplace_back();
  all.triangle_count = static_cast<std::uint32_t>(to.triangles.size());
  for (const Vec3& p : to.vertices) all.bounds.extend(p);
  const TriangleTree tree(surface);
  double largest_squared = 0;
  const auto measure = [&](const Vec3& p) {
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    const auto nearest = tree.nearest(tree.whole(), p, kAnywhere, TriangleTree::kNone);
    largest_squared = std::max(largest_squared, nearest.squared);
  };
  for (const Vec3& p : from.vertices) measure(p);
  for (const Triangle& t : from.triangles) {
    const Vec3 &a = from.vertices[t[0]], &b = from.vertices[t[1]], &c = from.vertices[t[2]];
    for (const Vec3& p : {Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2), Vec3((a + b + c) / 3)})
      measure(p);
  }
  return std::sqrt(largest_squared);
}

// The coarsest that is held to the tolerance as it is measured; the simplifier's own estimate may be less.
void simplify(Imported& imported, double tolerance) {
  const TriangleMesh fine = to_triangle_mesh(imported.model);
  double target = tolerance;
  for (int i = 0; i < kTries; ++i, target *= kFiner) {
    Model coarse = simplified(imported.model, target);
    const TriangleMesh mesh = to_triangle_mesh(coarse);
    const double deviation = std::max(farthest(fine, mesh), farthest(mesh, fine));
    if (deviation > tolerance) continue;
    if (mesh.triangles.size() >= imported.triangles) return;
    imported.drawn = std::move(coarse);
    imported.drawn_triangles = mesh.triangles.size();
    imported.drawn_deviation = deviation;
    return;
  }
}

}  // namespace

Result<Imported> import_file(const std::filesystem::path& file, const ImportOptions& options) {
  Result<ReadMesh> read = read_mesh(file);
  if (!read) return read.error();
  Imported imported;
  imported.format = read->format;
  imported.images = read->images;
  imported.lights = read->lights;
  imported.materials_left_out = std::move(read->materials_left_out);
  const Box3 box = box_of(read->model);
  imported.unit_m =
      options.unit ? Guess<double>{metres(*options.unit), {}} : guess_unit(*read, box.diagonal().norm());
  imported.up = options.up ? Guess<UpAxis>{*options.up, {}} : guess_up(*read);
  Eigen::Affine3d X_MF = Eigen::Affine3d::Identity();
  // Exactly, so that what stood square in the file does so in the model.
  if (imported.up.value == UpAxis::z) X_MF.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  X_MF.linear() *= imported.unit_m.value;
  imported.model = std::move(read->model);
  for (ModelPart& part : imported.model.parts) transform(part, X_MF);

  imported.size = box_of(imported.model).sizes();
  imported.triangles = count_triangles(imported.model);
  const TriangleMesh mesh = to_triangle_mesh(imported.model);
  imported.thin_triangles = count_thin(mesh);
  const auto solid = build_solid(mesh);
  if (solid)
    imported.mended = solid->notes;
  else
    imported.why_not_solid = solid.error().sentence;
  const double across = imported.size.norm();
  if (across > kLargest || across < kSmallest)
    imported.question = "Is that size meant? Otherwise give the unit that it was made in: --unit mm.";
  if (options.simplify) simplify(imported, *options.simplify);
  return imported;
}

}  // namespace fulcrum::importing
