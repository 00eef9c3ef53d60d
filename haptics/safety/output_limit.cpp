#include "haptics/safety/output_limit.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/clamp_norm.h"

namespace fulcrum {
namespace {

constexpr double kGathered = 1e-9;  // of a limit: what the sums before may have gathered
constexpr int kHalvings = 50;

// From the way that the last wrench would take to nothing: (3).
double aside(const Vec3& v, const Vec3& last) {
  const double square = last.squaredNorm();
  const double along = square > 0 ? std::clamp(v.dot(last) / square, 0.0, 1.0) : 0.0;
  return (v - along * last).norm();
}

// The largest part of `wanted`, 0 to 1, with |there + part wanted| <= limit.
double part_of_motor(double there, double wanted, double limit) {
  const double all = there + wanted;
  if (std::abs(all) <= limit * (1 + kGathered)) return 1;
  const double room = wanted > 0 ? limit - there : limit + there;
  return std::clamp(room / std::abs(wanted), 0.0, 1.0);
}

double part_of_vector(const Vec3& there, const Vec3& wanted, double limit) {
  if ((there + wanted).norm() <= limit * (1 + kGathered)) return 1;
  return part_beside(there, wanted, limit);
}

}  // namespace

double SlewSteps::part(const Wrench& from, const Wrench& to) const noexcept {
  const double by_force = (to.force - from.force).norm(), by_torque = (to.torque - from.torque).norm();
  const auto of = [](double step, double wanted) {
    return wanted > step * (1 + kGathered) ? step / wanted : 1.0;
  };
  return std::min(of(force, by_force), of(torque, by_torque));
}

OutputLimit::OutputLimit(const DeviceDesc& device, double tick_s)
    : max_force_(device.renders_force ? device.max_force : 0.0),
      max_torque_(device.renders_torque ? device.max_torque : 0.0),
      steps_(device, tick_s),
      limits_(Actuators(device).limits()) {}

std::uint32_t OutputLimit::hold(Output& output) noexcept {
  std::uint32_t faults = 0;
  for (Part* part : {&output.continuous, &output.transient}) {
    if (part->F_H_D.is_finite() && part->effort.allFinite()) continue;
    *part = {};
    faults |= kOutputLimited | kNotFinite;
  }
  const auto shorten = [&faults](Part& part, double by) {
    if (by == 1) return;
    part.F_H_D = part.F_H_D * by;
    part.effort *= by;
    faults |= kOutputLimited;
  };
  shorten(output.continuous, largest_part(output.continuous));
  shorten(output.transient, largest_part(output.continuous, output.transient));
  last_ = output.continuous.F_H_D;
  return faults;
}

double OutputLimit::largest_part(const Part& continuous) const noexcept {
  double part = largest_part({}, continuous);
  const Wrench& F = continuous.F_H_D;
  if (within_slew(F * part)) return part;
  double low = 0;  // nothing is always near enough
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + part);
    (within_slew(F * middle) ? low : part) = middle;
  }
  return low;
}

double OutputLimit::largest_part(const Part& continuous, const Part& transient) const noexcept {
  double part = std::min(part_of_vector(continuous.F_H_D.force, transient.F_H_D.force, max_force_),
                         part_of_vector(continuous.F_H_D.torque, transient.F_H_D.torque, max_torque_));
  for (Eigen::Index m = 0; m < limits_.size(); ++m)
    part = std::min(part, part_of_motor(continuous.effort[m], transient.effort[m], limits_[m]));
  return part;
}

bool OutputLimit::within_slew(const Wrench& F_H_D) const noexcept {
  return aside(F_H_D.force, last_.force) <= steps_.force * (1 + kGathered) &&
         aside(F_H_D.torque, last_.torque) <= steps_.torque * (1 + kGathered);
}

}  // namespace fulcrum
