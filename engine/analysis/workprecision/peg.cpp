// A peg that leans in a hole until it jams.

#include <array>
#include <numbers>
#include <vector>

#include "engine/analysis/shapes.h"
#include "engine/analysis/workprecision/bodies.h"
#include "engine/analysis/workprecision/press.h"
#include "haptics/math/functions.h"
#include "haptics/math/number_text.h"
#include "haptics/math/rotation.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr double kHole = 10e-3, kLength = 30e-3;  // m
constexpr double kCouple = 20e-3;                 // N m

// Where a rising function is zero.
template <class Rising>
double zero_of(const Rising& f) {
  double low = 0, high = 0.5;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0 ? low : high) = middle;
  }
  return low;
}

WorkStudy one_clearance(double clearance_mm, const std::vector<std::shared_ptr<const DistanceField>>& holes,
                        bool quick) {
  const std::string clearance = number_text(clearance_mm);
  WorkStudy study{
      "peg, " + clearance + " mm",
      "A round peg of 30 mm with " + clearance +
          " mm of clearance in a hole of 10 mm, leaned by a couple of 0.02 N m until it jams at both ends, 8 "
          "ways round; k = 20000 N/m an end. 2 F / k = d cos t + L sin t - D and F (L cos t - d sin t) = "
          "0.02 "
          "N m; under a constraint d cos t + L sin t = D. The peg's shell has four corners and 4092 points "
          "that touch nothing; on triangles both are tubes of facets. The error is that of the couple in the "
          "coupling, which the hand feels, over "
          "50 "
          "ticks after it has settled, root mean square over the places, of the truth; the work is a tick "
          "while the hand leans.",
      "voxel, or facet (mm)",
      "",
      {},
      {}};
  const double D = kHole, d = D - 1e-3 * clearance_mm, L = kLength, k = 20000;
  PressTask task;
  task.fields = holes;
  const Vec3 right(1, 0, 0), left(-1, 0, 0);  // the sides' own, which the classic method goes by
  task.shell = shell_touching(std::array{Vec3(d / 2, 0, L / 2), Vec3(-d / 2, 0, L / 2),
                                         Vec3(d / 2, 0, -L / 2), Vec3(-d / 2, 0, -L / 2)},
                              std::array{right, left, right, left}, 0.3 * d);
  task.stiffness = k;
  task.coupling = straight_springs();
  task.arm = 0.5 * L;
  const auto into = [&](double t) { return d * math::cos(t) + L * math::sin(t) - D; };
  const auto lever = [&](double t) { return L * math::cos(t) - d * math::sin(t); };
  const double rigid = zero_of(into);
  const double sprung = zero_of([&](double t) { return 0.5 * k * into(t) * lever(t) - kCouple; });
  const int places = quick ? 3 : 8;
  for (int i = 0; i < places; ++i) {
    const Quat q = quaternion_exp(Vec3(0, 0, golden_angle(i)));
    const Vec3 along(0, 0, 4e-3 * ((i + 0.5) / places - 0.5)), axis = q * Vec3::UnitY();
    const auto place = [&](double t) {
      const double held = t + kCouple / task.coupling.angular_stiffness;
      return PressPlace{
          {q, along}, {quaternion_exp(Vec3(held * axis)) * q, along}, {Vec3::Zero(), axis * kCouple}};
    };
    task.springs.push_back(place(sprung));
    task.rigid.push_back(place(rigid));
  }
  for (const int sides : quick ? std::vector{96} : std::vector{48, 96, 192}) {
    const double facet = std::numbers::pi * D / sides;
    task.faceted.push_back({facet, features_of(tube_mesh(0.3 * d, 0.5 * d, L, sides)),
                            features_of(tube_mesh(0.5 * D, 9e-3, 44e-3, sides))});
  }
  measure_presses(study, task);
  return study;
}

}  // namespace

std::vector<WorkStudy> study_pegs(bool quick) {
  const std::vector<double> voxels_mm = quick ? std::vector{0.5, 0.25} : std::vector{1.0, 0.5, 0.25};
  const auto holes = fields_of(tube_mesh(0.5 * kHole, 9e-3, 44e-3, quick ? 256 : 1024), voxels_mm);
  std::vector<WorkStudy> studies;
  for (const double clearance_mm : {0.4, 0.1, 0.025})
    studies.push_back(one_clearance(clearance_mm, holes, quick));
  return studies;
}

}  // namespace fulcrum::analysis::workprecision
