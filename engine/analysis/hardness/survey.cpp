#include "engine/analysis/hardness/survey.h"

#include <algorithm>
#include <numbers>

#include "engine/analysis/hardness/struck_surface.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::analysis::hardness {
namespace {

constexpr int kLeans = 8;              // of a mean over them
constexpr double kNoMore = 1e-12;      // N
constexpr double kPoseReached = 1e-6;  // m

double rad(double deg) {
  return deg * std::numbers::pi / 180;
}

// Of values that are added one by one.
class Mean {
public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  double value() const { return count_ > 0 ? sum_ / count_ : 0.0; }

private:
  double sum_ = 0;
  int count_ = 0;
};

struct MeanGain {
  Mean moment, hardness;
  void add(const Gain& gain) {
    moment.add(gain.moment);
    hardness.add(gain.hardness);
  }
  Gain value() const { return {moment.value(), hardness.value()}; }
};

Strike with_grasp_along(const Vec3& nhat_D, const Vec3& stylus_D) {
  Strike strike{nhat_D, math::acos(std::clamp(nhat_D.dot(stylus_D), -1.0, 1.0)), 0};
  const Vec3 towards = Strike{nhat_D, std::numbers::pi / 2, 0}.p_HG_D(1);
  strike.lean = math::atan2(stylus_D.dot(nhat_D.cross(towards)), stylus_D.dot(towards));
  return strike;
}

}  // namespace

HardnessRow HardnessSurvey::row(PulseMethod method, const Pose& X_DH, const std::string& pose,
                                const Vec3& nhat_D, double phi_deg) {
  const double phi = rad(phi_deg);
  HardnessRow row{.method = method,
                  .pose = pose,
                  .nhat_D = nhat_D,
                  .phi_deg = phi_deg,
                  .felt = striker_.strike(method, X_DH, {nhat_D, phi, 0})};
  std::vector<double> forces = struck_forces(device_, setting_, row.felt.force);
  row.rate_hardness = extended_rate_hardness(forces, setting_);
  if (!forces.empty()) forces.front() = row.felt.contact_force(phi, setting_.lever);
  row.felt_rate_hardness = extended_rate_hardness(forces, setting_);
  return row;
}

Gain HardnessSurvey::gain(PulseMethod method, const Pose& X_DH, const Strike& strike,
                          const PulseOutcome& force_only) {
  return gain_over(striker_.strike(method, X_DH, strike), force_only, strike.phi, setting_.lever);
}

std::vector<HardnessRow> HardnessSurvey::rows_at_home(std::span<const PulseMethod> methods,
                                                      std::span<const double> phis) {
  std::vector<HardnessRow> rows;
  for (const PulseMethod method : methods) {
    for (const Vec3& nhat_D : directions(kDirections))
      for (const double phi_deg : phis) rows.push_back(row(method, Pose{}, kHome, nhat_D, phi_deg));
  }
  return rows;
}

DirectionMap HardnessSurvey::map(PulseMethod method, double phi_deg, bool all_tilts) {
  DirectionMap map{method, phi_deg, all_tilts, {}};
  for (std::size_t cell = 0; cell < kAcross * kAcross; ++cell) {
    const std::optional<Vec3> nhat_D = sky_direction(cell);
    map.cells.emplace_back();
    if (!nhat_D) continue;
    const int leans = all_tilts ? kLeans : 1;
    MeanGain mean;
    for (int lean = 0; lean < leans; ++lean) {
      const Strike strike{*nhat_D, rad(phi_deg), 2 * std::numbers::pi * lean / kLeans};
      const PulseOutcome force_only = striker_.strike(PulseMethod::force_only, Pose{}, strike);
      mean.add(gain(method, Pose{}, strike, force_only));
    }
    map.cells.back() = mean.value();
  }
  return map;
}

AngleCurve HardnessSurvey::over_angles(PulseMethod method) {
  AngleCurve curve{method, setting_.speed, {}};
  for (const double phi_deg : {0.0,  0.25, 0.5,  1.0,  1.5,  2.0,  3.0,  4.0,  5.0,  7.5,  10.0, 12.5,
                               15.0, 20.0, 25.0, 30.0, 37.5, 45.0, 52.5, 60.0, 67.5, 75.0, 82.5, 90.0}) {
    Mean moment;
    MeanGain gains;
    for (const Vec3& nhat_D : directions(kPoseDirections)) {
      const Strike strike{nhat_D, rad(phi_deg), 0};
      const PulseOutcome felt = striker_.strike(method, Pose{}, strike);
      moment.add(felt.moment_D.norm());
      gains.add(gain_over(felt, striker_.strike(PulseMethod::force_only, Pose{}, strike), strike.phi,
                          setting_.lever));
    }
    curve.at.push_back({phi_deg, moment.value(), gains.value()});
  }
  return curve;
}

TiltSample HardnessSurvey::lean(double lean_deg) {
  const Strike strike{Vec3::UnitY(), rad(kPhi), rad(lean_deg)};
  return {lean_deg, striker_.strike(PulseMethod::force_only, Pose{}, strike),
          striker_.as_printed(Pose{}, strike), striker_.strike(PulseMethod::algorithm1, Pose{}, strike),
          striker_.strike(PulseMethod::exact, Pose{}, strike)};
}

PoseAt HardnessSurvey::pose(const Vec3& p_DH) {
  PoseAt at;
  at.p_DH = p_DH;
  const Pose X_DH{Quat::Identity(), p_DH};
  if (device_.kinematics == Kinematics::arms) {
    Mechanism mechanism(device_.mechanism);
    mechanism.follow(X_DH);
    at.reached = mechanism.out_of_reach() < kPoseReached;
  } else {
    at.reached = true;
  }
  if (!at.reached) return at;
  MeanGain algorithm1, exact, spare;
  for (const Vec3& nhat_D : directions(kPoseDirections)) {
    const Strike strike{nhat_D, rad(kPhi), 0};
    const PulseOutcome force_only = striker_.strike(PulseMethod::force_only, X_DH, strike);
    algorithm1.add(gain(PulseMethod::algorithm1, X_DH, strike, force_only));
    exact.add(gain(PulseMethod::exact, X_DH, strike, force_only));
    spare.add(gain(PulseMethod::force_only_spare, X_DH, strike, force_only));
  }
  at.algorithm1 = algorithm1.value();
  at.exact = exact.value();
  at.spare = spare.value();
  return at;
}

Front HardnessSurvey::front(const std::string& name, const Vec3& nhat_D) {
  const Strike strike{nhat_D.normalized(), rad(kPhi), 0};
  Front front;
  front.name = name;
  for (int i = -24; i <= 24; ++i) {
    const double weight = math::pow(10.0, i / 12.0);
    Striker weighted(device_, setting_, weight);
    const PulseOutcome felt = weighted.strike(PulseMethod::exact, Pose{}, strike);
    front.at.push_back({weight, felt.force, felt.moment_D.norm()});
  }
  front.force_only = striker_.strike(PulseMethod::force_only, Pose{}, strike);
  front.algorithm1 = striker_.strike(PulseMethod::algorithm1, Pose{}, strike);
  front.exact = striker_.strike(PulseMethod::exact, Pose{}, strike);
  return front;
}

TickMethod HardnessSurvey::in_the_tick(PulseMethod method) {
  TickMethod tick;
  tick.method = method;
  Mean force, moment, cut;
  MeanGain gain;
  for (const Vec3& nhat_D : directions(kDirections)) {
    const Strike strike{nhat_D, rad(kPhi), 0};
    const PulseOutcome felt = striker_.in_the_tick(method, Pose{}, strike);
    const PulseOutcome able = striker_.strike(method, Pose{}, strike);
    force.add(felt.force);
    moment.add(felt.moment_D.norm());
    cut.add(felt.missing > able.missing + kNoMore ? 1.0 : 0.0);
    gain.add(gain_over(felt, striker_.in_the_tick(PulseMethod::force_only, Pose{}, strike), strike.phi,
                       setting_.lever));
  }
  tick.force = force.value();
  tick.moment = moment.value();
  tick.gain = gain.value();
  tick.cut = cut.value();
  return tick;
}

DirectionMeans HardnessSurvey::means(PulseMethod method, std::span<const Strike> strikes) {
  DirectionMeans means;
  means.method = method;
  means.largest_gain = 0;
  Mean force, moment, gains, helped, lowered;
  for (const Strike& strike : strikes) {
    const PulseOutcome felt = striker_.strike(method, Pose{}, strike);
    const double gain =
        gain_over(felt, striker_.strike(PulseMethod::force_only, Pose{}, strike), strike.phi, setting_.lever)
            .moment;
    force.add(felt.force);
    moment.add(felt.moment_D.norm());
    gains.add(gain);
    helped.add(gain > 1 + kNoticed ? 1.0 : 0.0);
    lowered.add(gain < 1 - kNoticed ? 1.0 : 0.0);
    means.largest_gain = std::max(means.largest_gain, gain);
  }
  means.force = force.value();
  means.moment = moment.value();
  means.gain = gains.value();
  means.helped = helped.value();
  means.lowered = lowered.value();
  return means;
}

DirectionMeans HardnessSurvey::over_directions(PulseMethod method) {
  std::vector<Strike> strikes;
  for (const Vec3& nhat_D : directions(kManyDirections)) strikes.push_back({nhat_D, rad(kPhi), 0});
  return means(method, strikes);
}

DirectionMeans HardnessSurvey::along_stylus(PulseMethod method, const Vec3& stylus_D) {
  std::vector<Strike> strikes;
  for (const Vec3& nhat_D : directions(kManyDirections))
    strikes.push_back(with_grasp_along(nhat_D, stylus_D));
  return means(method, strikes);
}

ShownMethod HardnessSurvey::shown(PulseMethod method) {
  ShownMethod shown;
  shown.method = method;
  shown.speed = setting_.speed;
  Mean force, tilt, turned;
  for (const Vec3& nhat_D : directions(kDirections)) {
    const Strike strike{nhat_D, rad(kPhi), 0};
    const PulseOutcome felt = striker_.strike(method, Pose{}, strike);
    const Vec3 own = setting_.wanted_force() * strike.p_HG_D(setting_.lever).cross(nhat_D);
    force.add(felt.force);
    tilt.add(felt.tilt);
    turned.add(angle_between(felt.moment_D, own));
    shown.largest_tilt = std::max(shown.largest_tilt, felt.tilt);
    shown.largest_moment = std::max(shown.largest_moment, felt.moment_D.norm() / own.norm());
  }
  shown.force = force.value();
  shown.tilt = tilt.value();
  shown.turned = turned.value();
  return shown;
}

// The grasp along stylus_D, whatever that makes phi and lean.
PaperAxis HardnessSurvey::axis(const std::string& name, const Vec3& nhat_D, const Vec3& stylus_D) {
  const Strike strike = with_grasp_along(nhat_D, stylus_D);
  return {name,
          nhat_D,
          strike.phi,
          strike.lean,
          striker_.strike(PulseMethod::force_only, Pose{}, strike),
          striker_.as_printed(Pose{}, strike),
          striker_.strike(PulseMethod::algorithm1, Pose{}, strike),
          striker_.strike(PulseMethod::exact, Pose{}, strike)};
}

}  // namespace fulcrum::analysis::hardness
