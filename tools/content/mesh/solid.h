#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

namespace fulcrum::content {

inline constexpr double mm = 1e-3;  // plant drawings are in millimetres, models in metres
inline constexpr double pi = 3.14159265358979323846;
inline constexpr double degree = pi / 180.0;

using Triangle = std::array<std::uint32_t, 3>;

// A closed body: points are shared by the triangles around them, and a triangle's corners run
// counter-clockwise seen from outside.
struct Solid {
  std::vector<Eigen::Vector3d> points;  // (n x 3) m
  std::vector<Triangle> triangles;      // (m x 3) indices into points

  std::uint32_t add_point(const Eigen::Vector3d& p);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  // Corners in order around the quad. Split along the shorter diagonal, so that slim quads on bends and
  // fillets do not fold.
  void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
};

Solid transformed(Solid solid, const Eigen::Isometry3d& X);

// Enclosed volume (m^3), negative when the triangles face inwards.
double signed_volume(const Solid& solid);

void turn_outward(Solid* solid);

// A frame at a point with its z axis along a direction and its x axis along a world axis where it can be.
Eigen::Isometry3d frame_along(const Eigen::Vector3d& origin, const Eigen::Vector3d& z_direction);

}  // namespace fulcrum::content
