#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analysis/hardness/nearest_wrench.h"
#include "engine/analysis/hardness/report.h"
#include "engine/analysis/hardness/struck_surface.h"
#include "engine/analysis/hardness/tables.h"
#include "tests/haptics/actuation/arms.h"
#include "tests/haptics/actuation/w6d.h"

namespace fulcrum::analysis::hardness {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

DeviceDesc six_axis() {
  DeviceDesc desc;
  desc.renders_torque = true;
  desc.max_force = 8;
  desc.max_torque = 0.3;
  return desc;
}

// The paper's frame: x towards the person, y up.
DeviceDesc w6d_in_D() {
  DeviceDesc desc = w6d::device(0.255, 0.145);
  desc.mechanism.q_DK = Quat(Eigen::AngleAxisd(-kRightAngle, Vec3::UnitY()));
  return desc;
}

const HardnessStudy& study() {
  static const HardnessStudy result =
      study_hardness("w6d", w6d_in_D(), StrikeSetting{}, [](std::string_view, double) {});
  return result;
}

TEST(Strike, TheGraspIsAtItsAngleAndSide) {
  SplitMix random(3);
  for (int i = 0; i < 200; ++i) {
    const Strike strike{arms::random_vector(random).normalized(), 1.5 * random.uniform(),
                        6 * random.uniform()};
    const Vec3 r = strike.p_HG_D(0.12);
    EXPECT_NEAR(r.norm(), 0.12, 1e-15);
    EXPECT_NEAR(r.dot(strike.nhat_D), 0.12 * std::cos(strike.phi), 1e-15);
  }
  EXPECT_NEAR((Strike{Vec3::UnitY(), kRightAngle, 0}.p_HG_D(1) - Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR((Strike{Vec3::UnitY(), kRightAngle, kRightAngle}.p_HG_D(1) - Vec3::UnitX()).norm(), 0, 1e-15);
  EXPECT_NEAR((Strike{Vec3::UnitZ(), kRightAngle, 0}.p_HG_D(1) - Vec3::UnitY()).norm(), 0, 1e-15);
}

TEST(Strike, TheWantedForceStopsTheHandInOneTick) {
  EXPECT_NEAR(StrikeSetting{}.wanted_force(), 67.5, 1e-12);
}

// A motor for each axis: force along x is bounded by 8 N, torque about z by .3 N m, and neither takes of the
// other.
TEST(Strike, AMotorForEachAxisGivesAllItsMomentBesideAllItsForce) {
  Striker striker(six_axis(), StrikeSetting{});
  const Strike strike{Vec3::UnitX(), kRightAngle, kRightAngle};  // r along -y: r x f along z
  const double own = 0.12 * 8;
  EXPECT_NEAR(striker.strike(PulseMethod::force_only, {}, strike).moment_D.norm(), own, 1e-12);
  for (const PulseMethod method : {PulseMethod::algorithm1, PulseMethod::exact}) {
    const PulseOutcome felt = striker.strike(method, {}, strike);
    EXPECT_NEAR(felt.force, 8, 1e-11);  // kept with a part in 10^12 to spare
    EXPECT_NEAR(felt.moment_D.norm(), own + 0.3, 1e-9) << name_of(method);
    EXPECT_NEAR(felt.gamma, 8 / 67.5, 1e-12);
    EXPECT_NEAR(felt.delta(), 0.3 / (0.12 * 59.5), 1e-9);
    EXPECT_NEAR(felt.contact_force(strike.phi, 0.12), std::sqrt((64 + 10.5 * 10.5) / 2), 1e-8);
  }
  // The sign as printed takes it away.
  EXPECT_NEAR(striker.as_printed({}, strike).moment_D.norm(), own - 0.3, 1e-12);
}

// What the device's file gives for the whole bounds a pulse in the tick, and each method knows of it: exact
// is not cut afterwards, so that no other comes out ahead in what it makes small.
TEST(Strike, InTheTickTheWholeIsHeldAndExactIsAhead) {
  SplitMix random(9);
  for (const DeviceDesc& device : {w6d_in_D(), arms::serial6(), six_axis()}) {
    Striker striker(device, StrikeSetting{});
    int cut = 0;
    for (int i = 0; i < 300; ++i) {
      const Strike strike{arms::random_vector(random).normalized(), 1.5 * random.uniform(),
                          6 * random.uniform()};
      const PulseOutcome exact = striker.in_the_tick(PulseMethod::exact, {}, strike);
      const double wanted = striker.setting().wanted_force();
      const auto squares = [&](const PulseOutcome& felt) {
        const Vec3 r = strike.p_HG_D(0.12), f = wanted * strike.nhat_D;
        return (f - felt.F_H_D.force).squaredNorm() +
               (r.cross(f) - felt.moment_D).squaredNorm() / (0.12 * 0.12);
      };
      for (const PulseMethod method :
           {PulseMethod::force_only, PulseMethod::algorithm1, PulseMethod::exact}) {
        const PulseOutcome felt = striker.in_the_tick(method, {}, strike);
        EXPECT_LE(felt.F_H_D.force.norm(), device.max_force * (1 + 1e-9)) << name_of(method);
        EXPECT_LE(felt.F_H_D.torque.norm(), device.max_torque * (1 + 1e-9)) << name_of(method);
        EXPECT_GE(squares(felt), squares(exact) - 1e-9 * wanted * wanted) << name_of(method);
      }
      cut += exact.missing > striker.strike(PulseMethod::exact, {}, strike).missing + 1e-9;
    }
    if (device.kinematics == Kinematics::arms) EXPECT_GT(cut, 0);
  }
}

TEST(Strike, WithoutAMomentTheContactForceIsTheForce) {
  Striker striker(w6d_in_D(), StrikeSetting{});
  for (const double phi : {0.0, 0.4, 1.2}) {
    const PulseOutcome felt = striker.strike(PulseMethod::force_only, {}, {Vec3(0.6, 0.8, 0), phi, 0.3});
    EXPECT_NEAR(felt.contact_force(phi, 0.12), felt.force, 1e-12);
    EXPECT_NEAR(felt.delta(), 0, 1e-12);
  }
}

TEST(Strike, NoGainAtPhi0) {
  Striker striker(w6d_in_D(), StrikeSetting{});
  for (const Vec3& nhat_D : directions(50)) {
    for (const PulseMethod method : {PulseMethod::force_only, PulseMethod::force_only_spare,
                                     PulseMethod::algorithm1, PulseMethod::exact}) {
      const PulseOutcome felt = striker.strike(method, {}, {nhat_D, 0, 0});
      EXPECT_NEAR(felt.moment_D.norm(), 0, 1e-9) << name_of(method);
      EXPECT_NEAR(felt.delta(), 0, 1e-12);
    }
  }
}

TEST(Strike, TheFeltMomentIsNeverPastTheContactsOwnAndAlongIt) {
  SplitMix random(5);
  for (const double speed : {0.005, 0.02, 0.15}) {
    StrikeSetting setting;
    setting.speed = speed;
    for (const DeviceDesc& device : {w6d_in_D(), arms::serial6(), six_axis()}) {
      Striker striker(device, setting);
      for (int i = 0; i < 200; ++i) {
        const Strike strike{arms::random_vector(random).normalized(), 1.5 * random.uniform(),
                            6 * random.uniform()};
        const Vec3 own = strike.p_HG_D(setting.lever).cross(setting.wanted_force() * strike.nhat_D);
        for (const PulseMethod method : {PulseMethod::algorithm1, PulseMethod::exact}) {
          const PulseOutcome felt = striker.strike(method, {}, strike);
          EXPECT_LE(felt.moment_D.norm(), own.norm() * (1 + 1e-9));
          EXPECT_NEAR(felt.moment_D.cross(own).norm(), 0, 1e-9);
          EXPECT_NEAR(felt.tilt, 0, 1e-7);
        }
      }
    }
  }
}

TEST(NearestWrench, AgainstASearchOverTheBox) {
  SplitMix random(7);
  for (int i = 0; i < 100; ++i) {
    Eigen::MatrixXd A(4, 3);
    Eigen::VectorXd b(4), limits(3);
    for (Eigen::Index j = 0; j < 12; ++j) A(j / 3, j % 3) = 2 * random.uniform() - 1;
    for (Eigen::Index j = 0; j < 4; ++j) b[j] = 3 * (2 * random.uniform() - 1);
    for (Eigen::Index j = 0; j < 3; ++j) limits[j] = i % 10 == 0 && j == 1 ? 0 : random.uniform();
    const Eigen::VectorXd x = bounded_least_squares(A, b, limits);
    for (Eigen::Index j = 0; j < 3; ++j) EXPECT_LE(std::abs(x[j]), limits[j]);
    const double found = (A * x - b).norm();
    constexpr int steps = 24;
    for (int u = -steps; u <= steps; ++u) {
      for (int v = -steps; v <= steps; ++v) {
        for (int w = -steps; w <= steps; ++w) {
          const Eigen::VectorXd y = limits.cwiseProduct(Eigen::Vector3d(u, v, w) / steps);
          EXPECT_GE((A * y - b).norm(), found - 1e-12);
        }
      }
    }
  }
}

TEST(NearestWrench, TiltsTheForceOrLeavesTheContactsMoment) {
  StrikeSetting setting;
  Striker striker(w6d_in_D(), setting);
  const Strike up{Vec3::UnitY(), kRightAngle / 2, 0};
  const PulseOutcome exact = striker.strike(PulseMethod::exact, {}, up);
  const PulseOutcome nearest = striker.strike(PulseMethod::nearest_wrench, {}, up);
  const PulseOutcome free = striker.strike(PulseMethod::free_moment, {}, up);
  EXPECT_LE(nearest.missing, free.missing + 1e-9);
  EXPECT_LE(free.missing, exact.missing + 1e-9);
  EXPECT_GT(nearest.tilt, 0.1);
  EXPECT_NEAR(free.tilt, 0, 1e-6);
}

// Without device mass, damping and friction: a spring has its stiffness, less what the mass has slowed by
// then.
TEST(StruckSurface, RateHardness) {
  DeviceDesc bare;
  bare.handle_mass = bare.damping = bare.friction = 0;
  StrikeSetting setting;
  const std::vector<double> spring = struck_forces(bare, setting, 0);
  EXPECT_EQ(spring[0], 0);
  EXPECT_NEAR(spring[1], 5678 * 0.15e-3, 1e-9);
  EXPECT_NEAR(extended_rate_hardness(spring, setting), 5678, 1e-6);
  const std::vector<double> pulse = struck_forces(bare, setting, 3);
  EXPECT_NEAR(pulse[0], 3, 1e-12);
  EXPECT_NEAR(pulse[1], 5678 * (0.15e-3 - 0.5 * 3 / 0.45 * 1e-6), 1e-9);
  EXPECT_NEAR(extended_rate_hardness(pulse, setting), 3 / (1e-3 * 0.15), 1e-9);
}

// The whole pulse stops the hand in its tick.
TEST(StruckSurface, AWholePulseStopsTheHand) {
  DeviceDesc bare;
  bare.handle_mass = bare.damping = bare.friction = 0;
  const StrikeSetting setting;
  const std::vector<double> forces = struck_forces(bare, setting, setting.wanted_force());
  EXPECT_LE(forces.size(), 2u);
  EXPECT_NEAR(extended_rate_hardness(forces, setting), 0.45 / 1e-6, 1e-6);
}

TEST(Hardness, CsvHasItsColumnsAndMethodsOfOneForceHaveOneHardness) {
  const std::string text = hardness_csv(study()).text();
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "device,method,pose,direction,phi_deg,force_N,moment_Nm,felt_force_N,felt_moment_Nm,"
            "extended_rate_hardness_N_per_m,gamma,delta");
  for (const char* start : {"\nw6d,none,home,1 0 0,0,0,0,0,0,", "\nw6d,force_only,home,0 1 0,45,",
                            "\nw6d,force_only_spare,home,", "\nw6d,algorithm1,home,", "\nw6d,exact,home,"})
    EXPECT_NE(text.find(start), std::string::npos) << start;
  std::vector<double> force_only, algorithm1;
  for (const HardnessRow& row : study().rows) {
    if (row.method == PulseMethod::force_only) force_only.push_back(row.rate_hardness);
    if (row.method == PulseMethod::algorithm1) algorithm1.push_back(row.rate_hardness);
  }
  ASSERT_EQ(force_only.size(), algorithm1.size());
  for (std::size_t i = 0; i < force_only.size(); ++i)
    EXPECT_NEAR(algorithm1[i], force_only[i], 1e-9 * force_only[i]);
}

// Force and moment of the other sign are the efforts of the other sign: half of the sky is enough.
TEST(Hardness, OppositeSurfacesAreTheSame) {
  Striker striker(w6d_in_D(), StrikeSetting{});
  for (const Vec3& nhat_D : directions(40)) {
    for (const PulseMethod method : {PulseMethod::algorithm1, PulseMethod::exact}) {
      const PulseOutcome one = striker.strike(method, {}, {nhat_D, 0.8, 0}),
                         other = striker.strike(method, {}, {-nhat_D, 0.8, 0});
      EXPECT_NEAR(one.force, other.force, 1e-9);
      EXPECT_NEAR(one.moment_D.norm(), other.moment_D.norm(), 1e-9);
    }
  }
}

TEST(Hardness, TheSkyIsEvenlyCut) {
  Vec3 sum = Vec3::Zero();
  double inside = 0;
  for (std::size_t cell = 0; cell < kAcross * kAcross; ++cell) {
    const auto nhat_D = sky_direction(cell);
    if (!nhat_D) continue;
    EXPECT_NEAR(nhat_D->norm(), 1, 1e-12);
    EXPECT_GE(nhat_D->y(), 0);
    if (nhat_D->y() == 0) continue;
    sum += *nhat_D;
    ++inside;
  }
  EXPECT_NEAR((sum / inside - Vec3(0, 0.5, 0)).norm(), 0, 0.01);  // of a half sphere, by areas
  EXPECT_LT(sky_direction(12)->z(), -0.9) << "the top is away from the person";
}

// The paper's pose with the grasp where the stylus is: the saturated motor is loaded further by the moment.
TEST(Hardness, Algorithm1FindsNoMomentAtThePapersPose) {
  ASSERT_EQ(study().axes.size(), 3u);
  const double gamma[] = {1.394 / 67.5, 1.295 / 67.5, 2.600 / 67.5};
  for (std::size_t i = 0; i < 3; ++i) {
    const PaperAxis& axis = study().axes[i];
    EXPECT_NEAR(axis.algorithm1.gamma, gamma[i], 5.1e-4 / 67.5) << axis.name;
    EXPECT_NEAR(axis.algorithm1.delta(), 0, 1e-9) << axis.name;
    EXPECT_LT(axis.as_printed.moment_D.norm(), 0.99 * axis.force_only.moment_D.norm()) << axis.name;
    EXPECT_GT(axis.exact.moment_D.norm(), 1.3 * axis.force_only.moment_D.norm()) << axis.name;
    EXPECT_GT(axis.exact.force, 1.3 * axis.force_only.force) << axis.name;
  }
  EXPECT_NEAR(study().axes[0].phi, kRightAngle / 2, 0.01);
}

// On the device's own stylus there is hardly a direction in which Algorithm 1 finds a moment: half a per
// cent.
TEST(Hardness, OnItsOwnStylusAlgorithm1FindsHardlyAMoment) {
  ASSERT_EQ(study().along_stylus.size(), 4u);
  const DirectionMeans& algorithm1 = study().along_stylus[2];
  ASSERT_EQ(algorithm1.method, PulseMethod::algorithm1);
  EXPECT_LT(algorithm1.helped, 0.01);
  EXPECT_GT(study().along_stylus[3].helped, 0.9) << "exact";
}

// The rows are a sample: their mean is off by up to a twelfth, and the page says what it is over very many.
TEST(Hardness, TheRowsMeanIsThatOfVeryManyDirectionsNearly) {
  for (const DirectionMeans& means : study().means) {
    const MethodSummary rows = summary_of(study(), means.method, kPhi);
    EXPECT_NEAR(rows.gain.moment, means.gain, means.gain / 12) << name_of(means.method);
    EXPECT_NEAR(rows.helped, means.helped, 0.03) << name_of(means.method);
  }
}

TEST(Hardness, ExactIsNeverWorseInItsOwnObjective) {
  for (const DeviceDesc& device : {w6d_in_D(), arms::serial6()}) {
    const PulseChecks checks = check_pulses(device);
    EXPECT_EQ(checks.cases, 10000u);
    EXPECT_LE(checks.worst_margin, 1e-9);
    EXPECT_GT(checks.clamped, 1000u);
    EXPECT_GT(checks.better, checks.clamped / 20);
    EXPECT_LE(checks.largest_load, 1 + 1e-12);
  }
}

TEST(Hardness, ADeviceWithoutTorqueGainsNothing) {
  const HardnessStudy arm =
      study_hardness("arm", arms::phantom(), StrikeSetting{}, [](std::string_view, double) {});
  for (const PulseMethod method : {PulseMethod::algorithm1, PulseMethod::exact}) {
    const MethodSummary summary = summary_of(arm, method, kPhi);
    EXPECT_NEAR(summary.least_gain, 1, 1e-9);
    EXPECT_NEAR(summary.largest_gain, 1, 1e-9);
  }
  const std::string html = hardness_page(arm).html();
  EXPECT_NE(html.find("renders no torque"), std::string::npos);
  EXPECT_EQ(html.find("The paper"), std::string::npos);
}

TEST(Hardness, ThePageAnswers) {
  const std::string html = hardness_page(study()).html();
  for (const char* text : {"67.5 N", "φ = 0", "δ", "never worse", "nearest wrench", "<svg", "N m", "43 %"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::analysis::hardness
