#include "tools/content/piping/gauge.h"

#include <array>

#include "haptics/math/rotation.h"
#include "tools/content/mesh/fasteners.h"
#include "tools/content/mesh/loft.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double case_radius = 23 * mm;
constexpr double stem_length = 30 * mm;  // from the pipe's wall to the case
constexpr double dial_depth = 6 * mm;    // of the dial's face, above the case's middle
constexpr double lip = 9 * mm;           // of the bezel, above the case's middle

Solid gauge_case() {
  const double r = case_radius;
  const std::array<RadiusHeight, 10> profile{{{r - 3 * mm, -9 * mm},
                                              {r - 1.2 * mm, -8 * mm},
                                              {r - 1.2 * mm, 3 * mm},
                                              {r, 3 * mm},
                                              {r, lip - 1 * mm},
                                              {r - 1 * mm, lip},
                                              {r - 2.2 * mm, lip},
                                              {r - 3.2 * mm, lip - 0.6 * mm},
                                              {r - 3.2 * mm, dial_depth - 1 * mm},
                                              {r - 6 * mm, dial_depth - 1 * mm}}};
  return lathe(profile, 48);
}

void add_dial(Plant* plant, const std::string& name, const Isometry3d& X_WD) {
  const std::array<RadiusHeight, 2> face{
      {{case_radius - 3.1 * mm, dial_depth - 2.5 * mm}, {case_radius - 3.1 * mm, dial_depth}}};
  plant->add("gauge/" + name + "/dial", Finish::white, X_WD, lathe(face, 40));
  // Three quarters of a turn of scale; the marks are let into the dial.
  constexpr int marks = 11;
  for (int k = 0; k < marks; ++k) {
    const double angle = (225.0 - 27.0 * k) * degree;
    const Isometry3d X = X_WD * turn_by(angle, Vector3d::UnitZ()) *
                         Translation3d(case_radius - 6.2 * mm, 0.0, dial_depth - 0.9 * mm);
    const double half_long = k % 5 == 0 ? 2.2 * mm : 1.3 * mm;
    plant->add("gauge/" + name + "/mark/" + std::to_string(k), Finish::black, X,
               chamfered_box({half_long, 1.0 * mm, 1.05 * mm}, 0.05 * mm));
  }
  const Isometry3d needle = X_WD * turn_by(112.0 * degree, Vector3d::UnitZ());
  plant->add("gauge/" + name + "/needle", Finish::red_paint,
             needle * Translation3d(4 * mm, 0, dial_depth + 1 * mm),
             chamfered_box({9 * mm, 1.05 * mm, 1.05 * mm}, 0.25 * mm));
  const std::array<RadiusHeight, 3> boss{
      {{3 * mm, dial_depth - 1 * mm}, {3 * mm, dial_depth + 2.2 * mm}, {2.4 * mm, dial_depth + 2.7 * mm}}};
  plant->add("gauge/" + name + "/boss", Finish::black, X_WD, lathe(boss, 16));
}

}  // namespace

void add_gauge(Plant* plant, const std::string& name, const Isometry3d& X_WG, double pipe_radius) {
  const double socket = pipe_radius + 7 * mm;
  const double top = pipe_radius + stem_length;
  const std::array<RadiusHeight, 5> weldolet{{{9.5 * mm, 0.5 * pipe_radius},
                                              {9.5 * mm, pipe_radius + 1 * mm},
                                              {8.0 * mm, pipe_radius + 3 * mm},
                                              {8.0 * mm, socket - 0.6 * mm},
                                              {7.4 * mm, socket}}};
  plant->add_round("gauge/" + name + "/socket", Finish::bare_steel, X_WG, lathe(weldolet, 24), 24, 8 * mm);
  const std::array<RadiusHeight, 4> stem{{{4.5 * mm, socket - 1 * mm},
                                          {4.5 * mm, top - 6 * mm},
                                          {5.5 * mm, top - 3 * mm},
                                          {5.5 * mm, top + 4 * mm}}};
  plant->add("gauge/" + name + "/stem", Finish::brass, X_WG, lathe(stem, 20));
  plant->add("gauge/" + name + "/nut", Finish::brass, X_WG * Translation3d(0, 0, socket + 5 * mm),
             nut(m8, 24));

  // The dial's frame: z_D where it looks, y_D up.
  Eigen::Matrix3d R_GD;
  R_GD.col(0) = Vector3d::UnitY();
  R_GD.col(1) = Vector3d::UnitZ();
  R_GD.col(2) = Vector3d::UnitX();
  Isometry3d X_WD = X_WG * Translation3d(0, 0, top + case_radius - 1 * mm);
  X_WD.linear() = X_WG.linear() * R_GD;
  plant->add("gauge/" + name + "/case", Finish::brass, X_WD, gauge_case());
  add_dial(plant, name, X_WD);
}

}  // namespace fulcrum::content
