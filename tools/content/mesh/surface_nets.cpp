#include "tools/content/mesh/surface_nets.h"

// S. Gibson, "Constrained Elastic Surface Nets", 1998. The constraint is kept: a point never leaves its cell,
// so that neighbouring facets cannot fold over each other.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t no_point = 0xffffffffU;
constexpr int pulls = 2;             // towards the surface
constexpr double kept_share = 0.94;  // of a cell's width that its point may wander in

// Whether the corners of a cell whose bits are set hang together along its edges.
bool in_one_piece(unsigned corners) {
  if (corners == 0 || corners == 0xffU) return true;
  unsigned reached = corners & (~corners + 1U);
  for (int step = 0; step < 7; ++step) {
    const unsigned x = (reached & 0x55U) << 1U | (reached & 0xaaU) >> 1U;
    const unsigned y = (reached & 0x33U) << 2U | (reached & 0xccU) >> 2U;
    const unsigned z = (reached & 0x0fU) << 4U | (reached & 0xf0U) >> 4U;
    reached |= (x | y | z) & corners;
  }
  return reached == corners;
}

class Nets {
public:
  Nets(const Implicit& body, const GridLines& lines)
      : body_(body), lines_(lines), nx_(lines.x.size()), ny_(lines.y.size()), nz_(lines.z.size()) {
    values_.reserve(nx_ * ny_ * nz_);
    for (const double z : lines.z) {
      for (const double y : lines.y)
        for (const double x : lines.x) values_.push_back(body({x, y, z}));
    }
  }

  Solid make() {
    while (!every_cell_is_simple()) {
    }
    points_.assign(values_.size(), no_point);
    for (std::size_t k = 0; k + 1 < nz_; ++k) {
      for (std::size_t j = 0; j + 1 < ny_; ++j)
        for (std::size_t i = 0; i + 1 < nx_; ++i) add_point(i, j, k);
    }
    const std::array<std::size_t, 3> step{1, nx_, nx_ * ny_};
    for (std::size_t k = 1; k + 1 < nz_; ++k) {
      for (std::size_t j = 1; j + 1 < ny_; ++j) {
        for (std::size_t i = 1; i + 1 < nx_; ++i)
          for (std::size_t axis = 0; axis < 3; ++axis)
            add_quad(index(i, j, k), step[axis], step[(axis + 1) % 3], step[(axis + 2) % 3]);
      }
    }
    turn_outward(&solid_);
    return std::move(solid_);
  }

private:
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const { return (k * ny_ + j) * nx_ + i; }

  Vector3d corner(std::size_t i, std::size_t j, std::size_t k) const {
    return {lines_.x[i], lines_.y[j], lines_.z[k]};
  }

  // A cell that two parts of the surface pass would tie them together in its one point. Such places, where
  // two parts come within a cell of each other, are filled, corner by corner, until there is none.
  bool every_cell_is_simple() {
    bool simple = true;
    for (std::size_t k = 0; k + 1 < nz_; ++k) {
      for (std::size_t j = 0; j + 1 < ny_; ++j) {
        for (std::size_t i = 0; i + 1 < nx_; ++i) {
          unsigned inside = 0;
          std::size_t shallowest = 0;
          double least = std::numeric_limits<double>::infinity();
          for (unsigned c = 0; c < 8; ++c) {
            const std::size_t at = index(i + (c & 1U), j + (c >> 1U & 1U), k + (c >> 2U));
            if (values_[at] < 0.0) inside |= 1U << c;
            if (values_[at] >= 0.0 && values_[at] < least) {
              least = values_[at];
              shallowest = at;
            }
          }
          if (in_one_piece(inside) && in_one_piece(~inside & 0xffU)) continue;
          values_[shallowest] = -1e-6;
          simple = false;
        }
      }
    }
    return simple;
  }

  void add_point(std::size_t i, std::size_t j, std::size_t k) {
    std::array<double, 8> value{};
    int inside = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      value[c] = values_[index(i + (c & 1U), j + (c >> 1U & 1U), k + (c >> 2U))];
      inside += value[c] < 0.0 ? 1 : 0;
    }
    if (inside == 0 || inside == 8) return;
    const Vector3d low = corner(i, j, k);
    const Vector3d size = corner(i + 1, j + 1, k + 1) - low;
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    for (std::size_t a = 0; a < 8; ++a) {
      for (std::size_t bit = 1; bit < 8; bit <<= 1U) {
        const std::size_t b = a | bit;
        if (b == a || (value[a] < 0.0) == (value[b] < 0.0)) continue;
        const double t = value[a] / (value[a] - value[b]);
        const auto place = [](std::size_t c) {
          return Vector3d(static_cast<double>(c & 1U), static_cast<double>(c >> 1U & 1U),
                          static_cast<double>(c >> 2U));
        };
        sum += (1.0 - t) * place(a) + t * place(b);
        ++count;
      }
    }
    Vector3d p = low + (sum / count).cwiseProduct(size);
    const Vector3d margin = 0.5 * (1.0 - kept_share) * size;
    for (int pull = 0; pull < pulls; ++pull) {
      const Vector3d g = gradient(body_, p, 0.05 * size.minCoeff());
      p -= body_(p) / std::max(g.squaredNorm(), 0.04) * g;
      p = p.cwiseMax(low + margin).cwiseMin(low + size - margin);
    }
    points_[index(i, j, k)] = solid_.add_point(p);
  }

  // The quad around the grid edge from `at` along `along`, through the four cells about it.
  void add_quad(std::size_t at, std::size_t along, std::size_t u, std::size_t v) {
    const bool from_inside = values_[at] < 0.0;
    if (from_inside == (values_[at + along] < 0.0)) return;
    const std::uint32_t a = points_[at - u - v];
    const std::uint32_t b = points_[at - v];
    const std::uint32_t c = points_[at];
    const std::uint32_t d = points_[at - u];
    if (from_inside)
      solid_.add_quad(a, b, c, d);
    else
      solid_.add_quad(d, c, b, a);
  }

  const Implicit& body_;
  const GridLines& lines_;
  std::size_t nx_, ny_, nz_;
  std::vector<double> values_;         // (nx ny nz) x runs fastest
  std::vector<std::uint32_t> points_;  // of the cell above each corner
  Solid solid_;
};

}  // namespace

std::vector<double> grid_line(double first, double last, const std::function<double(double)>& step) {
  std::vector<double> line{first};
  while (line.back() < last) line.push_back(line.back() + step(line.back()));
  const double stretch = (last - first) / (line.back() - first);
  for (double& at : line) at = first + stretch * (at - first);
  return line;
}

Solid surface_nets(const Implicit& body, const GridLines& lines) {
  return Nets(body, lines).make();
}

Vector3d gradient(const Implicit& body, const Vector3d& p, double reach) {
  Vector3d g;
  for (int k = 0; k < 3; ++k) {
    const Vector3d aside = reach * Vector3d::Unit(k);
    g[k] = (body(p + aside) - body(p - aside)) / (2.0 * reach);
  }
  return g;
}

}  // namespace fulcrum::content
