#pragma once
// Mesh files as other programs write them, of shapes whose size is known.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace fulcrum::importing::test {

struct Shape {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline Shape box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  Shape shape;
  for (int corner = 0; corner < 8; ++corner)
    shape.points.emplace_back(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                              corner & 4 ? high.z() : low.z());
  shape.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return shape;
}

inline Shape torus(double ring, double tube, std::uint32_t around, std::uint32_t across) {
  Shape shape;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      const double r = ring + tube * std::cos(b);
      shape.points.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
      const auto at = [&](std::uint32_t k, std::uint32_t l) { return k % around * across + l % across; };
      shape.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      shape.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return shape;
}

inline std::string obj(const Shape& shape, const std::string& head = "") {
  std::string text = head;
  char line[128];
  for (const auto& p : shape.points) {
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", p.x(), p.y(), p.z());
    text += line;
  }
  for (const auto& t : shape.triangles) {
    std::snprintf(line, sizeof line, "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line;
  }
  return text;
}

inline std::string ply(const Shape& shape, const std::string& comment = "") {
  std::string text =
      "ply\nformat ascii 1.0\n" + comment + "element vertex " + std::to_string(shape.points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nelement face " +
      std::to_string(shape.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  char line[128];
  for (const auto& p : shape.points) {
    std::snprintf(line, sizeof line, "%.9g %.9g %.9g 255 188 0\n", p.x(), p.y(), p.z());
    text += line;
  }
  for (const auto& t : shape.triangles) {
    std::snprintf(line, sizeof line, "3 %u %u %u\n", t[0], t[1], t[2]);
    text += line;
  }
  return text;
}

template <class T>
std::string bytes_of(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

inline std::string floats_of(const Eigen::Vector3d& p) {
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis) bytes += bytes_of(static_cast<float>(p[axis]));
  return bytes;
}

// Binary, with normals that say nothing.
inline std::string stl(const Shape& shape, const std::string& head = "") {
  std::string bytes = head;
  bytes.resize(80, ' ');
  bytes += bytes_of(static_cast<std::uint32_t>(shape.triangles.size()));
  for (const auto& t : shape.triangles) {
    bytes += floats_of(Eigen::Vector3d::Zero());
    for (const std::uint32_t corner : t) bytes += floats_of(shape.points[corner]);
    bytes += bytes_of(std::uint16_t{0});
  }
  return bytes;
}

inline std::string chunk_3ds(std::uint16_t id, const std::string& content) {
  return bytes_of(id) + bytes_of(static_cast<std::uint32_t>(6 + content.size())) + content;
}

inline std::string max_3ds(const Shape& shape, const std::string& name) {
  std::string points = bytes_of(static_cast<std::uint16_t>(shape.points.size()));
  for (const auto& p : shape.points) points += floats_of(p);
  std::string faces = bytes_of(static_cast<std::uint16_t>(shape.triangles.size()));
  for (const auto& t : shape.triangles) {
    for (const std::uint32_t corner : t) faces += bytes_of(static_cast<std::uint16_t>(corner));
    faces += bytes_of(std::uint16_t{7});
  }
  const std::string mesh = chunk_3ds(0x4100, chunk_3ds(0x4110, points) + chunk_3ds(0x4120, faces));
  const std::string object = chunk_3ds(0x4000, name + std::string(1, '\0') + mesh);
  return chunk_3ds(0x4d4d, chunk_3ds(0x0002, bytes_of(std::uint32_t{3})) + chunk_3ds(0x3d3d, object));
}

// A folder that goes when this does.
class MeshFolder {
public:
  MeshFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fulcrum-import-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::filesystem::filesystem_error("mkdtemp", {});
    folder_ = pattern;
  }
  ~MeshFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  MeshFolder(const MeshFolder&) = delete;
  MeshFolder& operator=(const MeshFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

private:
  std::filesystem::path folder_;
};

}  // namespace fulcrum::importing::test
