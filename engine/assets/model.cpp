#include "engine/assets/model.h"

#include <utility>

namespace fulcrum {
namespace {

void make_unit(std::vector<Vec3>& normals) {
  for (Vec3& normal : normals) {
    const double length = normal.stableNorm();
    normal = length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::UnitY());
  }
}

}  // namespace

void transform(ModelPart& part, const Eigen::Affine3d& X) {
  const Mat3 linear = X.linear();
  const Mat3 for_normals = linear.inverse().transpose();
  for (Vec3& p : part.positions) p = X * p;
  for (Vec3& n : part.normals) n = for_normals * n;
  make_unit(part.normals);
  if (linear.determinant() < 0.0)  // a mirror turns triangles inside out
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3)
      std::swap(part.indices[i + 1], part.indices[i + 2]);
}

TriangleMesh to_triangle_mesh(const Model& model) {
  TriangleMesh mesh;
  for (const ModelPart& part : model.parts) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.positions.begin(), part.positions.end());
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
      mesh.triangles.push_back(
          {first + part.indices[i], first + part.indices[i + 1], first + part.indices[i + 2]});
    }
  }
  return mesh;
}

}  // namespace fulcrum
