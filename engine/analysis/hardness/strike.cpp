#include "engine/analysis/hardness/strike.h"

#include <cmath>

#include "engine/analysis/hardness/nearest_wrench.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::hardness {
namespace {

constexpr double kAlong = 0.99;     // a normal this near to the person's direction: the stylus leans upwards
constexpr double kNoMoment = 1e-9;  // of the lever: a contact without moment at the grasp
constexpr double kNoBound = 1e6;    // times the device's own

DeviceDesc motors_alone(DeviceDesc device) {
  if (device.kinematics == Kinematics::arms) {
    device.max_force *= kNoBound;
    device.max_torque *= kNoBound;
  }
  return device;
}

}  // namespace

Vec3 Strike::p_HG_D(double lever) const {
  const Vec3 person = std::abs(nhat_D.z()) > kAlong ? Vec3::UnitY() : Vec3::UnitZ();
  const Vec3 towards = (person - nhat_D * nhat_D.dot(person)).normalized();
  const Vec3 side = math::cos(lean) * towards + math::sin(lean) * nhat_D.cross(towards);
  return lever * (math::cos(phi) * nhat_D + math::sin(phi) * side);
}

const char* name_of(PulseMethod method) {
  switch (method) {
    case PulseMethod::none:
      return "none";
    case PulseMethod::force_only:
      return "force_only";
    case PulseMethod::force_only_spare:
      return "force_only_spare";
    case PulseMethod::algorithm1:
      return "algorithm1";
    case PulseMethod::exact:
      return "exact";
    case PulseMethod::nearest_wrench:
      return "nearest_wrench";
    case PulseMethod::free_moment:
      return "free_moment";
  }
  return "";
}

const char* title_of(PulseMethod method) {
  switch (method) {
    case PulseMethod::none:
      return "no pulse";
    case PulseMethod::force_only:
      return "force only";
    case PulseMethod::force_only_spare:
      return "force only, spare motors";
    case PulseMethod::algorithm1:
      return "Algorithm 1";
    case PulseMethod::exact:
      return "exact";
    case PulseMethod::nearest_wrench:
      return "nearest wrench";
    case PulseMethod::free_moment:
      return "free moment";
  }
  return "";
}

double PulseOutcome::contact_force(double phi, double lever) const {
  const double s = math::sin(phi);
  return std::sqrt((force * force + moment_D.squaredNorm() / (lever * lever)) / (1 + s * s));
}

Striker::Methods::Methods(const DeviceDesc& device, double moment_weight)
    : exact(device, {.method = AllocationMethod::exact, .moment_weight = moment_weight}),
      algorithm1(device, {.method = AllocationMethod::algorithm1, .moment_weight = 1}),
      pseudoinverse(device, {.method = AllocationMethod::pseudoinverse, .moment_weight = 1}) {}

Striker::Striker(const DeviceDesc& device, const StrikeSetting& setting, double moment_weight)
    : setting_(setting), motors_(motors_alone(device), moment_weight), device_(device, moment_weight) {}

PulseOutcome Striker::felt(const Wrench& F_H_D, const Strike& strike) const {
  const double wanted = setting_.wanted_force();
  const Vec3 r = strike.p_HG_D(setting_.lever), f_des = wanted * strike.nhat_D, whole = r.cross(f_des);
  PulseOutcome felt;
  felt.F_H_D = F_H_D;
  felt.moment_D = r.cross(F_H_D.force) - F_H_D.torque;
  felt.force = F_H_D.force.dot(strike.nhat_D);
  felt.tilt = math::atan2(F_H_D.force.cross(strike.nhat_D).norm(), felt.force);
  felt.gamma = felt.force / wanted;
  felt.mu = whole.norm() > kNoMoment * wanted * setting_.lever
                ? felt.moment_D.dot(whole) / whole.squaredNorm()
                : felt.gamma;
  felt.missing = math::hypot((f_des - F_H_D.force).norm(), (whole - felt.moment_D).norm() / setting_.lever);
  return felt;
}

PulseOutcome Striker::strike(Methods& methods, PulseMethod method, const Pose& X_DH,
                             const Strike& strike) const {
  const Vec3 f_D = setting_.wanted_force() * strike.nhat_D, p_HG_D = strike.p_HG_D(setting_.lever);
  const auto by = [&](Allocator& motors) {
    motors.begin(X_DH);
    return felt(motors.pulse({f_D, Vec3::Zero()}, p_HG_D, setting_.lever).F_H_D, strike);
  };
  switch (method) {
    case PulseMethod::none:
      return felt({}, strike);
    case PulseMethod::force_only:
      return by(methods.pseudoinverse);
    case PulseMethod::force_only_spare:
      methods.exact.begin(X_DH);
      return felt(methods.exact.allocate_uniform({f_D, Vec3::Zero()}).F_H_D, strike);
    case PulseMethod::algorithm1:
      return by(methods.algorithm1);
    case PulseMethod::exact:
      return by(methods.exact);
    case PulseMethod::nearest_wrench:
    case PulseMethod::free_moment:
      methods.exact.begin(X_DH);
      return felt(nearest_wrench(methods.exact.actuators(), f_D, p_HG_D, method == PulseMethod::free_moment),
                  strike);
  }
  return {};
}

PulseOutcome Striker::strike(PulseMethod method, const Pose& X_DH, const Strike& strike) {
  return this->strike(motors_, method, X_DH, strike);
}

PulseOutcome Striker::in_the_tick(PulseMethod method, const Pose& X_DH, const Strike& strike) {
  return this->strike(device_, method, X_DH, strike);
}

// Line 9 of it turned round is line 9 for a grasp on the other side.
PulseOutcome Striker::as_printed(const Pose& X_DH, const Strike& strike) {
  const Vec3 f_D = setting_.wanted_force() * strike.nhat_D;
  motors_.algorithm1.begin(X_DH);
  return felt(
      motors_.algorithm1.pulse({f_D, Vec3::Zero()}, -strike.p_HG_D(setting_.lever), setting_.lever).F_H_D,
      strike);
}

}  // namespace fulcrum::analysis::hardness
