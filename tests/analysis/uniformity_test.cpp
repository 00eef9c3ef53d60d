// References: the formulas of what a hand feels, and the figures for them that are known.

#include "engine/analysis/uniformity/uniformity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "engine/analysis/uniformity/report.h"
#include "engine/analysis/uniformity/tables.h"

namespace fulcrum::analysis::uniformity {
namespace {

// The figures of a Freedom 6S, a motor for each axis.
DeviceDesc device() {
  DeviceDesc d;
  d.name = "six axes";
  d.renders_torque = true;
  d.max_force = 2.5;
  d.max_torque = 0.45;
  d.handle_mass = 0.25;
  d.handle_inertia = Vec3(5e-6, 1.7e-4, 1.7e-4);
  d.angular_damping = Vec3(1e-4, 1.25e-3, 2e-3);
  d.handle_weight = 0;
  d.damping = 0.75;
  d.encoder_step = 10e-6;
  return d;
}

const UniformityStudy& study() {
  static const UniformityStudy study = study_uniformity(device(), {}, 8, [](std::string_view, double) {});
  return study;
}

double mean_inertia() {  // N, m a without tremor
  return 0.25 * StrikePath{}.acceleration;
}

TEST(Uniformity, UncompensatedIsAsTheFormulasSay) {
  int rows = 0;
  for (const UniformityRow& row : study().rows) {
    if (row.method == InertiaMethod::acceleration) continue;
    ++rows;
    EXPECT_LT(row.formula_error, 0.01) << name_of(row.method) << ' ' << row.place << ' ' << row.stiffness;
    EXPECT_EQ(row.limited, 0);
    // An encoder's half count, half a tick at 40 mm/s and the field's 5 um.
    EXPECT_LT(row.depth_error, 30e-6);
    EXPECT_LT(row.resistance, 0.02 * row.stiffness * StrikePath{}.depth) << row.stiffness;
    // Without tremor f_h / x is K - m a / x.
    const double depth = StrikePath{}.depth + 0.04e-3;  // of a tick and a half of the motion
    // The rest is the tremor's acceleration, 0.15 m/s^2 rms, in the mean of eight strikes.
    EXPECT_NEAR(row.felt_stiffness, row.stiffness - mean_inertia() / depth,
                4 * 0.25 * 0.15 / depth / std::sqrt(8.0));
  }
  EXPECT_EQ(rows, 2 * 6 * 11);
}

TEST(Uniformity, WithAccelerationTheBallIsAlikeAlongTheStick) {
  for (const double stiffness : kStiffnesses) {
    const StickSummary s = summary_of(study(), InertiaMethod::acceleration, stiffness);
    EXPECT_LE(s.worst, 0.08) << stiffness;
    EXPECT_LE(s.torque_over, 1) << stiffness;
    EXPECT_LT(s.jump, 1e-3) << stiffness;
    EXPECT_GT(s.scatter, 1) << "an encoder and a tremor scatter";
    EXPECT_EQ(s.limited, 0);
  }
}

TEST(Uniformity, TheArmJumpsByWhatItTakesOff) {
  for (const double stiffness : kStiffnesses) {
    const StickSummary s = summary_of(study(), InertiaMethod::arm, stiffness);
    // |g| f, f = K x.
    EXPECT_NEAR(s.jump, 0.105 * stiffness * 3.04e-3, 0.03 * s.jump) << stiffness;
  }
}

TEST(Uniformity, TheTableHasAllRowsAndColumns) {
  const std::string text = uniformity_csv(study()).text();
  EXPECT_TRUE(text.starts_with(
      "method,place_m,assigned_stiffness_N_per_m,felt_stiffness_N_per_m,felt_torque_error_Nm,"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 3 * 6 * 11);
}

TEST(Uniformity, TheSameStudyIsTheSameToTheBit) {
  const UniformityStudy again = study_uniformity(device(), {}, 8, [](std::string_view, double) {});
  EXPECT_EQ(uniformity_csv(again).text(), uniformity_csv(study()).text());
}

// step() itself, with the filter on an even acceleration.
TEST(Uniformity, WithTheTrueAccelerationItIsExactToRounding) {
  EXPECT_LT(study().true_acceleration, 1e-9);
}

TEST(Uniformity, ThePapersExampleComesOutByTheRightSigns) {
  const InertiaChecks& checks = study().checks;
  EXPECT_NEAR(checks.wanted, 0.0300, 1e-12);
  EXPECT_NEAR(checks.uncompensated, 0.0475, 1e-12);
  EXPECT_NEAR(checks.as_printed, 0.0050, 1e-12);
}

TEST(Uniformity, FiltersAreWhatTheySay) {
  for (const FilterRow& row : study().filters) {
    if (row.kind != AccelerationEstimatorKind::kalman) continue;
    EXPECT_NEAR(row.measured_lag, row.lag, 0.02 * row.lag) << row.jerk;
    // Counts are white enough at the speeds of that motion.
    EXPECT_NEAR(row.measured_noise, row.noise, 0.25 * row.noise) << row.jerk;
  }
}

TEST(Uniformity, WhatComesTooLateFades) {
  ASSERT_EQ(study().late.size(), 3u);
  const LateRun &in_time = study().late.front(), &late = study().late.back();
  EXPECT_LT(in_time.growth, 0);
  EXPECT_LT(in_time.faded_at, 0);
  EXPECT_GT(late.growth, 0);
  EXPECT_GT(late.faded_at, 0);
  EXPECT_GT(late.swing_unfaded, 3e-3);
  EXPECT_LT(late.swing, 0.3e-3) << "a tremor of 50 um is left";
  for (const LateRun& run : study().late) EXPECT_GT(run.least_port, -1e-4);
}

}  // namespace
}  // namespace fulcrum::analysis::uniformity
