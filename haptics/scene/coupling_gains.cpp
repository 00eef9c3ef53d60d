#include "haptics/scene/coupling_gains.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/device/linear_loop.h"
#include "haptics/math/bisect.h"
#include "haptics/math/number_text.h"

namespace fulcrum {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kMinStiffness = 1e-6;    // N/m or N m/rad
constexpr double kStiffest = 1e9;         // N/m or N m/rad, where the search ends
constexpr double kLimitPrecision = 1e-4;  // of a limit
constexpr double kNeutral = 1e-6;         // 1/s, of handle and tool that fly on together
constexpr double kMargin = 0.5;           // of a limit: a factor of two is left to what the model leaves out
constexpr double kSaturation = 0.9;       // of the device's largest force

// One degree of freedom of the handle: along an axis or about one.
struct Freedom {
  DeviceAxis axis;   // in D
  double stiffness;  // what the device renders of 1 of the coupling's
  double inertia;    // kg or kg m^2, which the coupling damps
  double tool;       // kg or kg m^2, of the tool in it; 0: it has none
};

double least_inertia(const ToolDesc& tool) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(tool.inertia_T, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

Freedom along(const PlainScene& desc) {
  const double scale = desc.mapping.position_scale * desc.mapping.force_scale;
  const DeviceDesc& device = desc.device;
  return {{device.handle_mass, device.damping, device.friction, device.encoder_step},
          scale,
          massless(desc.contact.response) ? desc.mapping.mass_in_world(device.handle_mass) : desc.tool.mass,
          massless(desc.contact.response) ? 0.0 : desc.tool.mass};
}

Freedom about(const PlainScene& desc, Eigen::Index axis) {
  const double scale = desc.mapping.energy_scale();
  const DeviceDesc& device = desc.device;
  const double inertia = device.handle_inertia[axis];
  return {{inertia, device.angular_damping[axis], device.angular_friction, device.encoder_step_rad},
          scale,
          massless(desc.contact.response) ? desc.mapping.inertia_in_world(inertia)
                                          : desc.tool.inertia_T.trace() / 3,
          massless(desc.contact.response) ? 0.0 : least_inertia(desc.tool)};
}

// The low-pass that is as late as the estimator.
double filter_pole_of(const PlainScene& desc) {
  const double late = VelocityEstimator(desc.velocity, desc.tick_s).delay() / desc.tick_s - 0.5;
  return late / (1 + late);
}

WallLoop loop_of(const Freedom& dof, const PlainScene& desc) {
  return {.axis = dof.axis, .tick_s = desc.tick_s, .filter_pole = filter_pole_of(desc)};
}

double limit_of(const Freedom& dof, const PlainScene& desc) {
  const WallLoop loop = loop_of(dof, desc);
  const auto holds = [&](double k) {
    const auto wall = [&](double inertia) {
      const double B = 2 * desc.coupling.damping_ratio * std::sqrt(k * inertia);
      return Wall{dof.stiffness * k, dof.stiffness * B};
    };
    if (k >= kStiffest || !(exact_growth(loop, wall(dof.inertia)) < 0)) return false;
    if (dof.tool == 0) return true;
    const FreeTool tool{dof.stiffness * dof.tool, desc.integrator};
    return exact_growth(loop, wall(dof.tool), tool) < kNeutral;
  };
  return end_above(kMinStiffness, kLimitPrecision, holds);
}

// N/m or N m/rad of the coupling. `otherwise`: where nothing limits it.
double suited(const Freedom& dof, double limit, double otherwise) {
  double k = limit < kNoLimit ? kMargin * limit : otherwise;
  if (limit < kNoLimit && dof.axis.friction > 0 && dof.axis.encoder_step > 0)
    k = std::min(k, 2 * dof.axis.friction / dof.axis.encoder_step / dof.stiffness);
  return k;
}

// About the axis of the handle that holds least.
Freedom about(const PlainScene& desc) {
  const DeviceDesc& device = desc.device;
  Freedom least = about(desc, 0);
  const auto alike = [](const Vec3& v) { return v.isConstant(v.x(), 0); };
  if (alike(device.handle_inertia) && alike(device.angular_damping)) return least;
  double limit = limit_of(least, desc);
  for (Eigen::Index axis = 1; axis < 3; ++axis) {
    const Freedom dof = about(desc, axis);
    const double holds = limit_of(dof, desc);
    if (holds < limit) {
      least = dof;
      limit = holds;
    }
  }
  return least;
}

std::string sentence(const char* key, double given, const char* unit, double limit) {
  return std::string(key) + " is " + number_text(given) + " " + unit +
         ", and the device, let go, holds at most " + number_text(limit) + " " + unit +
         ": it may buzz in a light hand. Lower it or the device's scales, or name a "
         "velocity_estimator that is less late.";
}

// A wall that is felt without a coupling.
std::optional<std::string> wall_beyond_limit(const PlainScene& desc) {
  if (!desc.device.renders_force) return std::nullopt;
  double stiffest = desc.contact.stiffness;
  for (const double level : desc.contact.levels) stiffest = std::max(stiffest, level);
  PlainScene undamped = desc;
  undamped.coupling.damping_ratio = 0;
  const double limit = limit_of(along(undamped), undamped);
  if (stiffest <= limit) return std::nullopt;
  return "contact.stiffness is " + number_text(stiffest) +
         " N/m, which the hand feels at once under the response direct, and the device, let go, holds at "
         "most " +
         number_text(limit) +
         " N/m: it may buzz in a light hand. Lower it, its levels or the device's scales.";
}

}  // namespace

StiffnessLimits coupling_limits(const PlainScene& desc) {
  return {desc.device.renders_force ? limit_of(along(desc), desc) : kNoLimit,
          desc.device.renders_torque ? limit_of(about(desc), desc) : kNoLimit};
}

CouplingDesc tune_coupling(const CouplingGains& given, const PlainScene& desc) {
  PlainScene with = desc;
  with.coupling.damping_ratio = given.damping_ratio;
  const StiffnessLimits limits = coupling_limits(with);
  const DeviceDesc& device = desc.device;
  const double force_scale = desc.mapping.force_scale;

  CouplingDesc coupling;
  coupling.damping_ratio = given.damping_ratio;
  coupling.stiffness =
      given.stiffness.value_or(suited(along(desc), limits.stiffness, CouplingDesc{}.stiffness));
  const double radius_squared = desc.tool.inertia_T.trace() / 3 / desc.tool.mass;  // of gyration
  coupling.angular_stiffness = given.angular_stiffness.value_or(
      std::min(coupling.stiffness * radius_squared, suited(about(desc), limits.angular_stiffness, kNoLimit)));
  coupling.max_force = given.max_force.value_or(
      device.renders_force ? kSaturation * device.max_force / force_scale : CouplingDesc{}.max_force);
  coupling.max_torque = given.max_torque.value_or(
      device.renders_torque ? kSaturation * device.max_torque / desc.mapping.energy_scale()
                            : coupling.max_force * std::sqrt(radius_squared));
  return coupling;
}

std::optional<std::string> beyond_limits(const PlainScene& desc) {
  if (!coupled(desc.contact.response)) return wall_beyond_limit(desc);
  const StiffnessLimits limits = coupling_limits(desc);
  if (desc.coupling.stiffness > limits.stiffness)
    return sentence("coupling.stiffness", desc.coupling.stiffness, "N/m", limits.stiffness);
  if (desc.coupling.angular_stiffness > limits.angular_stiffness)
    return sentence("coupling.angular_stiffness", desc.coupling.angular_stiffness, "N m/rad",
                    limits.angular_stiffness);
  return std::nullopt;
}

// The force is in N at the handle, the speed the scene's.
double damping_limit(const PlainScene& desc) {
  if (!desc.device.renders_force) return kNoLimit;
  return exact_damping_limit(loop_of(along(desc), desc)) / desc.mapping.position_scale;
}

}  // namespace fulcrum
