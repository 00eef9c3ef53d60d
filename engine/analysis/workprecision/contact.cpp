// Field, contact and sampling, against bodies whose distance is known.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/analysis/best_time.h"
#include "engine/analysis/shapes.h"
#include "engine/analysis/workprecision/bodies.h"
#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/contact/penalty.h"
#include "haptics/contact/query.h"
#include "haptics/contact/voxel_query.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr double kStiffness = 2000;  // N/m

// What both ways of finding contacts are asked: the force at a pose, and its cost.
struct Asked {
  double rms = 0;     // of force / truth - 1
  double cpu_us = 0;  // a pose
};

template <class Query>
Asked ask(Query& query, const std::vector<Pose>& poses, double region_radius, double truth) {
  ContactDesc desc;
  desc.stiffness = kStiffness;
  desc.dissipation = 0;
  desc.region_radius = region_radius;
  PenaltyResponse response(desc, RigidBody(0.1, Mat3::Identity() * 1e-5), 1e-3, Integrator::implicit_euler);
  ContactSet set;
  Asked asked;
  double sum = 0;
  const double us = best_us([&] {
    sum = 0;
    for (const Pose& X_WT : poses) {
      query.run(X_WT, set);
      const double off = response.push(set, {X_WT, {}}).F_T_W.force.norm() / truth - 1;
      sum += off * off;
    }
  });
  asked.cpu_us = us / static_cast<double>(poses.size());
  asked.rms = std::sqrt(sum / static_cast<double>(poses.size()));
  return asked;
}

// Trilinear and classic, side by side, method by method.
template <class Truth>
void compare(WorkStudy& study, const std::vector<double>& values, const Truth& at) {
  std::vector<WorkPoint> classic;
  for (const double value : values) {
    const auto [field, voxel] = at(value);
    study.points.push_back({"distance field", value, field.rms, field.cpu_us});
    classic.push_back({"classic voxels", value, voxel.rms, voxel.cpu_us});
  }
  study.points.insert(study.points.end(), classic.begin(), classic.end());
  study.baseline = "classic voxels";
  measure_orders(study);
}

}  // namespace

WorkStudy study_field(bool quick) {
  WorkStudy study{
      "ball",
      "The distance to a ball of 20 mm, sampled on a grid and looked up between its points, within 1 mm of "
      "the surface, stored as 16-bit or 32-bit numbers. Theory gives h²/(4R) for the largest error and order "
      "2; 16-bit numbers add half a quantum, which shrinks with the voxel. The work is a thousand look-ups.",
      "voxel (mm)",
      "m",
      {{"float32", 2}, {"int16", 2}},
      {}};
  const double R = 0.02;
  const TriangleMesh ball = ball_mesh(R, quick ? 32 : 128);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> off(-1e-3, 1e-3);
  std::vector<std::pair<Vec3, double>> places;
  for (int i = 0; i < (quick ? 20'000 : 100'000); ++i) {
    const double distance = off(random);
    places.emplace_back((R + distance) * random_direction(random), distance);
  }
  std::vector<WorkPoint> rounded;
  for (const double voxel_mm : quick ? std::vector{4.0, 2.0} : std::vector{4.0, 2.0, 1.0, 0.5}) {
    const auto float32 = field_of(ball, 1e-3 * voxel_mm, FieldFormat::float32);
    FieldData data = float32->data();
    quantise(data);
    const DistanceField int16(std::move(data));
    const auto point = [&](const char* name, const DistanceField& field) {
      double worst = 0;
      const double us = best_us([&] {
        for (const auto& [p, truth] : places) worst = std::max(worst, std::abs(field.distance(p) - truth));
      });
      return WorkPoint{name, voxel_mm, worst, 1e3 * us / static_cast<double>(places.size())};
    };
    study.points.push_back(point("float32", *float32));
    rounded.push_back(point("int16", int16));
  }
  study.points.insert(study.points.end(), rounded.begin(), rounded.end());
  measure_orders(study);
  return study;
}

WorkStudy study_tube(bool quick) {
  WorkStudy study{
      "tube",
      "A ball of 9 mm in a tube of 10 mm, 1.3 mm off its axis, pressed into the wall by 0.3 mm: "
      "F = k (e + r - R) = 0.6 N at k = 2000 N/m. The ball's shell has 4096 points, of which one touches; "
      "200 places round the tube. The error is the root mean square of F / 0.6 N - 1; the work is the query "
      "and the response at one pose.",
      "voxel (mm)",
      "",
      {{"distance field", 2}},
      {}};
  const double R = 10e-3, r = 9e-3, e = 1.3e-3;
  const TriangleMesh tube = tube_mesh(R, 13e-3, 30e-3, quick ? 256 : 1024);
  const auto shell = shell_touching(std::array{Vec3(r, 0, 0)}, std::array{Vec3(1, 0, 0)}, 0.75 * r);
  std::vector<Pose> poses;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> along(-5e-3, 5e-3);
  for (int i = 0; i < (quick ? 40 : 200); ++i) {
    const double angle = golden_angle(i);
    poses.push_back(
        {quaternion_exp(Vec3(0, 0, angle)), Vec3(e * math::cos(angle), e * math::sin(angle), along(random))});
  }
  compare(study, quick ? std::vector{1.0, 0.5} : std::vector{1.0, 0.5, 0.25, 0.125}, [&](double voxel_mm) {
    const auto field = field_of(tube, 1e-3 * voxel_mm);
    ContactQuery query(shell, field);
    VoxelQuery voxels(shell, field);
    const double truth = kStiffness * (e + r - R);
    return std::pair(ask(query, poses, 2e-3, truth), ask(voxels, poses, 2e-3, truth));
  });
  return study;
}

WorkStudy study_sampling(bool quick) {
  WorkStudy study{
      "plane",
      "A ball of 10 mm pressed 0.5 mm into a plane, turned in 200 ways, with a voxel of 0.5 mm. Over the cap "
      "that is inside, depth weighted by overlap volume is two thirds of the deepest: F = 2/3 k h. The "
      "error is the root mean square of F / truth - 1, the work the query and the response at one pose. "
      "An area-weighted region does not feel how many points sample it; where more points touch than a set "
      "holds, neighbours are taken together by the deepest of them, which is the error of the finest two.",
      "spacing of points (mm)",
      "",
      {},
      {}};
  const double r = 10e-3, h = 0.5e-3;
  const auto field = field_of(box_mesh({-0.03, -8e-3, -0.03}, {0.03, 0, 0.03}), 0.5e-3);
  std::mt19937_64 random(3);
  std::vector<Pose> poses;
  std::uniform_real_distribution<double> turn(0, std::numbers::pi);
  std::uniform_real_distribution<double> aside(-5e-3, 5e-3);
  for (int i = 0; i < (quick ? 40 : 200); ++i)
    poses.push_back(
        {quaternion_exp(turn(random) * random_direction(random)), Vec3(aside(random), r - h, aside(random))});
  compare(study, quick ? std::vector{1.0, 0.5} : std::vector{2.0, 1.0, 0.5, 0.25, 0.125},
          [&](double spacing_mm) {
            const auto shell = ball_shell(r, 1e-3 * spacing_mm);
            ContactQuery query(shell, field);
            VoxelQuery voxels(shell, field);
            const double truth = 2.0 / 3 * kStiffness * h;
            return std::pair(ask(query, poses, 50e-3, truth), ask(voxels, poses, 50e-3, truth));
          });
  return study;
}

}  // namespace fulcrum::analysis::workprecision
