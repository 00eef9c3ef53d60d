#include "tools/content/ear/pinna.h"

// Proportions: ordinary adult figures, a pinna of 62 by 34 mm.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "haptics/math/functions.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double thickness = 2.7;  // mm, of the sheet
constexpr double cell = 0.25;      // mm, of the table over x and y
constexpr double x_low = -40.0, x_high = 20.0, y_low = -36.0, y_high = 48.0;
constexpr auto columns = static_cast<std::size_t>((x_high - x_low) / cell) + 1;
constexpr auto rows = static_cast<std::size_t>((y_high - y_low) / cell) + 1;

std::vector<Cord> make_cords() {
  return {
      // Helix: from its crus in the concha forwards, up, over the top and down behind to its tail.
      Cord({{{-8.5, 4.6, 2.4}, 1.2},
            {{-4.0, 5.6, 4.6}, 1.8},
            {{1.0, 8.0, 6.2}, 2.2},
            {{4.6, 12.5, 7.4}, 2.4},
            {{6.0, 19.0, 8.6}, 2.5},
            {{4.2, 26.5, 10.0}, 2.5},
            {{-1.5, 32.6, 11.8}, 2.6},
            {{-9.5, 35.2, 13.9}, 2.7},
            {{-17.8, 33.4, 16.0}, 2.7},
            {{-24.0, 27.6, 17.6}, 2.6},
            {{-27.2, 19.6, 18.4}, 2.4},
            {{-27.8, 10.6, 18.2}, 2.1},
            {{-26.4, 1.8, 17.0}, 1.9},
            {{-23.4, -6.2, 15.2}, 1.8},
            {{-19.6, -12.6, 13.2}, 1.7}}),
      // Antihelix, and its upper crus
      Cord({{{-12.2, -9.0, 10.4}, 2.0},
            {{-16.6, -5.4, 12.4}, 2.5},
            {{-19.4, 1.4, 14.2}, 2.8},
            {{-19.6, 8.6, 14.9}, 2.9},
            {{-17.6, 15.2, 14.7}, 2.9},
            {{-15.0, 21.4, 14.0}, 2.8},
            {{-11.8, 27.0, 12.9}, 2.6},
            {{-8.0, 31.0, 11.8}, 2.2}}),
      // Its lower crus
      Cord({{{-17.8, 14.4, 14.2}, 2.3},
            {{-12.4, 17.4, 12.9}, 2.2},
            {{-6.4, 18.2, 11.0}, 2.0},
            {{-0.6, 17.8, 8.8}, 1.9},
            {{4.0, 17.0, 7.0}, 1.8}}),
      // Antitragus
      Cord({{{-3.2, -11.2, 7.2}, 1.9},
            {{-7.0, -11.0, 9.2}, 2.5},
            {{-10.6, -9.8, 10.0}, 2.4},
            {{-13.6, -8.0, 10.8}, 2.0}}),
      // Tragus: its free edge, and what fills it
      Cord({{{8.4, 6.2, 2.6}, 1.8},
            {{5.6, 3.6, 6.0}, 2.2},
            {{3.9, 0.4, 8.0}, 2.3},
            {{4.0, -3.2, 7.8}, 2.3},
            {{5.6, -7.0, 5.6}, 2.3}}),
      Cord({{{10.0, 4.4, 1.4}, 2.6},
            {{8.2, 1.6, 3.6}, 3.2},
            {{8.0, -2.6, 3.8}, 3.4},
            {{8.4, -6.8, 2.8}, 3.2},
            {{8.0, -11.0, 1.6}, 3.0}}),
      // Intertragic notch: its floor, from the tragus to the antitragus
      Cord({{{5.8, -7.0, 5.0}, 2.4},
            {{4.0, -10.4, 4.8}, 2.5},
            {{0.6, -12.2, 5.2}, 2.4},
            {{-3.4, -11.6, 7.0}, 2.1}}),
      // Where the lobule grows to the cheek
      Cord({{{5.4, -10.4, 3.2}, 2.8}, {{3.6, -14.6, 3.6}, 2.8}, {{1.6, -17.0, 4.6}, 2.0}}),
  };
}

// Where the sheet would be without the concha: it stands off more to the back.
double fan(double x, double y) {
  return 4.6 - 0.385 * (x - 4.0) + 0.0022 * (y - 6.0) * (y - 6.0) - 0.002 * x * x;
}

double ellipsoid(const Vector3d& p, const Vector3d& middle, const Vector3d& radii) {
  const Vector3d q = (p - middle).cwiseQuotient(radii);
  const double r = q.norm();
  const double slope = q.cwiseQuotient(radii).norm() / std::max(r, 1e-6);
  return (r - 1.0) / std::max(slope, 1e-3);
}

}  // namespace

Pinna::Pinna()
    : edge_({{3.0, -14.0},
             {6.0, -6.0},
             {7.5, 3.0},
             {7.0, 12.0},
             {7.4, 19.5},
             {5.2, 28.0},
             {-1.5, 34.2},
             {-10.0, 36.8},
             {-18.6, 34.8},
             {-25.2, 28.6},
             {-28.6, 20.0},
             {-29.2, 10.6},
             {-27.8, 1.4},
             {-24.8, -7.0},
             {-20.6, -14.2},
             {-15.4, -20.6},
             {-9.0, -24.6},
             {-2.6, -23.6},
             {1.4, -19.0}}),
      concha_({{2.8, -5.5},
               {3.6, 1.5},
               {2.6, 7.4},
               {1.6, 12.0},
               {-4.0, 15.6},
               {-11.0, 15.2},
               {-16.2, 10.6},
               {-17.4, 4.0},
               {-16.0, -2.6},
               {-12.0, -7.4},
               {-6.6, -9.0},
               {-2.0, -9.4},
               {1.6, -8.8}}),
      cords_(make_cords()) {
  table_.reserve(columns * rows);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      table_.push_back(
          computed(x_low + cell * static_cast<double>(i), y_low + cell * static_cast<double>(j)));
    }
  }
}

double Pinna::concha(double x, double y) const {
  return at(x, y).concha;
}

// Where two sides of its outline are equally near, the distance to it has a crease, which would be a scratch
// in the skin: the mean of what lies about has none.
double Pinna::in_concha(double x, double y) const {
  constexpr int places = 12;
  constexpr double about = 1.8;  // mm
  double sum = 0.0;
  for (int i = 0; i < places; ++i) {
    const double angle = 2.0 * pi * i / places;
    sum += concha_.distance({x + about * math::cos(angle), y + about * math::sin(angle)});
  }
  return smooth_step(1.2, -5.2, sum / places);
}

double Pinna::height(double x, double y) const {
  const double deep = in_concha(x, y);
  // The floor: the cavum around the canal's opening, the cymba above the crus of the helix.
  const double floor =
      -0.4 - 0.16 * (x + 2.0) + 0.17 * std::max(y - 4.0, 0.0) + 0.1 * std::max(-y - 6.0, 0.0);
  // The scapha and the triangular fossa are hollows between the cords.
  return fan(x, y) - 0.6 + deep * (floor - fan(x, y) + 0.6);
}

Pinna::Place Pinna::computed(double x, double y) const {
  constexpr double h = 0.1;
  const double dx = (height(x + h, y) - height(x - h, y)) / (2.0 * h);
  const double dy = (height(x, y + h) - height(x, y - h)) / (2.0 * h);
  const Vector2d p(x, y);
  return {height(x, y), std::sqrt(1.0 + dx * dx + dy * dy), edge_.distance(p), in_concha(x, y)};
}

Pinna::Place Pinna::at(double x, double y) const {
  const double u = std::clamp((x - x_low) / cell, 0.0, static_cast<double>(columns) - 1.001);
  const double v = std::clamp((y - y_low) / cell, 0.0, static_cast<double>(rows) - 1.001);
  const auto i = static_cast<std::size_t>(u);
  const auto j = static_cast<std::size_t>(v);
  const double s = u - static_cast<double>(i);
  const double t = v - static_cast<double>(j);
  const Place* a = &table_[j * columns + i];
  const Place* b = a + columns;
  const auto mix = [&](double Place::*m) {
    return (1 - t) * ((1 - s) * a[0].*m + s * a[1].*m) + t * ((1 - s) * b[0].*m + s * b[1].*m);
  };
  return {mix(&Place::z), mix(&Place::slope), mix(&Place::beyond), mix(&Place::concha)};
}

double Pinna::distance(const Vector3d& p) const {
  const Place place = at(p.x(), p.y());
  const double sheet = std::abs(p.z() - place.z) / place.slope - 0.5 * thickness;
  double result = smooth_max(sheet, place.beyond, 1.6);
  for (const Cord& cord : cords_) result = smooth_min(result, cord.distance(p), 2.6);
  const double lobule = ellipsoid(p, {-9.0, -16.6, 9.2}, {8.8, 8.2, 2.8});
  return smooth_min(result, lobule, 3.0);
}

}  // namespace fulcrum::content
