// Presses whose statics can be worked out by hand: into a tube, into a groove, onto a table's four legs.

#include <array>
#include <cmath>

#include "engine/analysis/shapes.h"
#include "engine/analysis/workprecision/bodies.h"
#include "engine/analysis/workprecision/press.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr const char* kHow =
    " The tool's shell has 4096 points. The error is that of the wrench in the coupling, which the hand "
    "feels, "
    "over 50 ticks after it has settled, root mean square over the places, of the truth; the work is a tick "
    "while the hand presses in.";

const std::vector<double>& voxels(bool quick) {
  static const std::vector<double> few{1.0, 0.5}, all{1.0, 0.5, 0.25};
  return quick ? few : all;
}

// A body that lies askew in its grid: no face is where voxels would have it.
Pose askew() {
  return {quaternion_exp(Vec3(0.31, 0.52, 0.23)), Vec3(0.13e-3, 0.07e-3, 0.19e-3)};
}

PressPlace moved_place(const PressPlace& place, const Pose& X) {
  return {X * place.X_WT_start, X * place.X_WG, {X.q * place.felt.force, X.q * place.felt.torque}};
}

}  // namespace

WorkStudy study_press_tube(bool quick) {
  WorkStudy study{
      "tube, pressed",
      std::string("A ball of 9 mm, pressed 1 mm beyond the wall of a tube of 10 mm, in 8 directions. Two "
                  "springs in series: F = k_c k x / (k_c + k) with k_c = 800, k = 2000 N/m, and k_c x where "
                  "the contact is a constraint. The force has a direction, too, and along the wall the ball "
                  "gives way to it: springs push along differences over a cell's width, of order 2, a "
                  "constraint along the gradient within a cell, of order 1. The classic method takes its "
                  "normals from the ball, where they are exact here.") +
          kHow,
      "voxel (mm)",
      "",
      {{"penalty", 2}, {"static", 2}, {"constraint", 1}},
      {}};
  const double R = 10e-3, r = 9e-3, x = 1e-3;
  PressTask task;
  task.fields = fields_of(tube_mesh(R, 13e-3, 20e-3, quick ? 256 : 1024),
                          quick ? voxels(quick) : std::vector{1.0, 0.5, 0.25, 0.125});
  task.shell = shell_touching(std::array{Vec3(r, 0, 0)}, std::array{Vec3(1, 0, 0)}, 0.75 * r);
  task.coupling = straight_springs();
  task.arm = r;
  const double k_c = task.coupling.stiffness, k = task.stiffness;
  const int places = quick ? 3 : 8;
  for (int i = 0; i < places; ++i) {
    const Quat q = quaternion_exp(Vec3(0, 0, golden_angle(i)));
    const Vec3 u = q * Vec3::UnitX(), along(0, 0, 6e-3 * ((i + 0.5) / places - 0.5));
    const Pose start{q, u * (R - r) + along}, goal{q, u * (R - r + x) + along};
    task.springs.push_back({start, goal, {u * (k_c * k * x / (k_c + k)), Vec3::Zero()}});
    task.rigid.push_back({start, goal, {u * (k_c * x), Vec3::Zero()}});
  }
  measure_presses(study, task);
  return study;
}

WorkStudy study_press_groove(bool quick) {
  WorkStudy study{
      "groove",
      std::string(
          "A ball of 5 mm pressed with 4 N into a groove of half angle 0.6 rad, k = 40000 N/m a side, "
          "that lies askew in its grid; 8 places along it. It sinks by W / (2 k sin² a), and a "
          "constraint not at all. Trilinear interpolation gives flat faces exactly: what remains is the "
          "rounding of stored distances and what a tick's rounds leave over.") +
          kHow,
      "voxel (mm)",
      "",
      {},
      {}};
  const double a = 0.6, side = 0.03, W = 4, r = 5e-3, k = 40000;
  const TriangleMesh slabs[] = {
      moved(box_mesh({0, -0.01, -0.02}, {0.01, side, 0.02}), {quaternion_exp(Vec3(0, 0, -a)), Vec3::Zero()}),
      moved(box_mesh({-0.01, -0.01, -0.02}, {0, side, 0.02}), {quaternion_exp(Vec3(0, 0, a)), Vec3::Zero()})};
  const Pose X = askew();
  PressTask task;
  task.fields = fields_of(moved(joined(slabs), X), voxels(quick));
  const std::array sides{Vec3(math::cos(a), -math::sin(a), 0), Vec3(-math::cos(a), -math::sin(a), 0)};
  task.shell = shell_touching(std::array{Vec3(r * sides[0]), Vec3(r * sides[1])}, sides, 0.5 * r);
  task.stiffness = k;
  task.coupling = straight_springs();
  task.arm = r;
  const double height = r / math::sin(a), sink = W / (2 * k * math::sin(a) * math::sin(a));
  const double pulled = W / task.coupling.stiffness;
  const int places = quick ? 3 : 8;
  for (int i = 0; i < places; ++i) {
    const double z = 20e-3 * ((i + 0.5) / places - 0.5);
    const Pose start{Quat::Identity(), Vec3(0, height, z)};
    const Wrench felt{Vec3(0, -W, 0), Vec3::Zero()};
    task.springs.push_back(
        moved_place({start, {Quat::Identity(), Vec3(0, height - sink - pulled, z)}, felt}, X));
    task.rigid.push_back(moved_place({start, {Quat::Identity(), Vec3(0, height - pulled, z)}, felt}, X));
  }
  measure_presses(study, task);
  return study;
}

WorkStudy study_press_table(bool quick) {
  WorkStudy study{
      "table",
      std::string(
          "A table on four legs, 20 mm from its middle each way, on a floor that lies askew in its "
          "grid, k = 20000 N/m a leg; loaded with 2 N, 4 mm beside the middle, in 8 places. Force and "
          "couple follow from the legs' depths; of a constraint's legs, only from the load. Flat "
          "again.") +
          kHow,
      "voxel (mm)",
      "",
      {},
      {}};
  const double a = 0.02, b = 0.02, P = 2, e = 4e-3, k = 20000;
  const Pose X = askew();
  PressTask task;
  task.fields = fields_of(moved(box_mesh({-0.035, -0.01, -0.035}, {0.035, 0, 0.035}), X), voxels(quick));
  const Vec3 down(0, -1, 0);
  task.shell = shell_touching(std::array{Vec3(a, -b, a), Vec3(a, -b, -a), Vec3(-a, -b, a), Vec3(-a, -b, -a)},
                              std::array{down, down, down, down}, 0.5 * b);
  task.stiffness = k;
  task.coupling = straight_springs();
  task.arm = a;
  const double k_c = task.coupling.stiffness, k_R = task.coupling.angular_stiffness;
  // Turned by t about its middle, which is b above the floor: legs at x cos t + b sin t.
  const double t = -P * e / (4 * k * a * a);
  const double couple = (4 * k * a * a * math::cos(t) - b * P) * math::sin(t);
  const int places = quick ? 3 : 8;
  for (int i = 0; i < places; ++i) {
    const Vec3 at(5e-3 * math::cos(golden_angle(i)) * std::sqrt((i + 0.5) / places), 0,
                  5e-3 * math::sin(golden_angle(i)) * std::sqrt((i + 0.5) / places));
    const Quat facing = quaternion_exp(Vec3(0, golden_angle(3 * i), 0));
    const auto place = [&](double angle, double height, double torque) {
      const Pose on_floor{facing, at};
      const PressPlace straight{
          {Quat::Identity(), Vec3(0, b, 0)},
          {quaternion_exp(Vec3(0, 0, angle + torque / k_R)), Vec3(0, height - P / k_c, 0)},
          {Vec3(0, -P, 0), Vec3(0, 0, torque)}};
      return moved_place(straight, X * on_floor);
    };
    task.springs.push_back(place(t, b * math::cos(t) - P / (4 * k), couple));
    task.rigid.push_back(place(0, b, -P * e));
  }
  measure_presses(study, task);
  return study;
}

}  // namespace fulcrum::analysis::workprecision
