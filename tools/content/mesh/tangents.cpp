#include "tools/content/mesh/tangents.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>

namespace fulcrum::content {
namespace {

struct Ways {
  Eigen::Vector3d u = Eigen::Vector3d::Zero();  // along which it grows, times twice an area in the picture
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
};

}  // namespace

std::vector<Eigen::Vector4f> tangents(const ShadedMesh& mesh, const std::vector<Eigen::Vector2f>& uv) {
  std::vector<Ways> ways(mesh.positions.size());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::array<std::uint32_t, 3> t{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    const Eigen::Vector3d e1 = (mesh.positions[t[1]] - mesh.positions[t[0]]).cast<double>();
    const Eigen::Vector3d e2 = (mesh.positions[t[2]] - mesh.positions[t[0]]).cast<double>();
    const Eigen::Vector2d d1 = (uv[t[1]] - uv[t[0]]).cast<double>(),
                          d2 = (uv[t[2]] - uv[t[0]]).cast<double>();
    const double side = d1.x() * d2.y() - d1.y() * d2.x() < 0.0 ? -1.0 : 1.0;
    for (const std::uint32_t corner : t) {
      ways[corner].u += side * (d2.y() * e1 - d1.y() * e2);
      ways[corner].v += side * (d1.x() * e2 - d2.x() * e1);
    }
  }
  std::vector<Eigen::Vector4f> made;
  made.reserve(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Eigen::Vector3d n = mesh.normals[i].cast<double>().normalized();
    Eigen::Vector3d along = ways[i].u - n * n.dot(ways[i].u);
    if (!(along.norm() > 0.0)) along = n.unitOrthogonal();  // a picture drawn out to a line: any way will do
    along.normalize();
    // v grows downwards in a picture, and relief is given with y upwards.
    const double w = n.cross(along).dot(ways[i].v) > 0.0 ? -1.0 : 1.0;
    made.emplace_back(static_cast<float>(along.x()), static_cast<float>(along.y()),
                      static_cast<float>(along.z()), static_cast<float>(w));
  }
  return made;
}

}  // namespace fulcrum::content
