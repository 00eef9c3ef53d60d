#include "engine/analysis/hardness/hardness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>

#include "engine/analysis/hardness/survey.h"
#include "haptics/math/functions.h"
#include "haptics/math/number_text.h"

namespace fulcrum::analysis::hardness {
namespace {

constexpr double kNothing = 1e-12;  // N m, or N
constexpr double kReach = 0.8;      // of the workspace's half extents

std::string position_text(const Vec3& p) {
  return number_text(p.x()) + " " + number_text(p.y()) + " " + number_text(p.z());
}

// The line that a spin turns the handle about leads from the first arm's end to the second's.
std::optional<Vec3> stylus_of(const DeviceDesc& device) {
  if (device.kinematics != Kinematics::arms || !device.mechanism.spin) return std::nullopt;
  const Mechanism mechanism(device.mechanism);
  return Vec3(mechanism.placed(1).X_DE.p - mechanism.placed(0).X_DE.p).normalized();
}

}  // namespace

Gain gain_over(const PulseOutcome& felt, const PulseOutcome& force_only, double phi, double lever) {
  const double moment = force_only.moment_D.norm(), force = force_only.contact_force(phi, lever);
  return {moment > kNothing ? felt.moment_D.norm() / moment : 1.0,
          force > kNothing ? felt.contact_force(phi, lever) / force : 1.0};
}

// Lambert's azimuthal projection: areas stay equal.
std::optional<Vec3> sky_direction(std::size_t cell) {
  const auto place = [](std::size_t i) {
    return 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(kAcross) - 1;
  };
  const double x = place(cell % kAcross), z = place(cell / kAcross), radius = math::hypot(x, z);
  if (radius >= 1 + std::numbers::sqrt2 / static_cast<double>(kAcross)) return std::nullopt;
  if (radius < kNothing) return Vec3::UnitY();
  const double up = std::max(0.0, 1 - radius * radius), level = std::sqrt(1 - up * up);
  return Vec3(level * x / radius, up, level * z / radius);
}

std::vector<Vec3> directions(std::size_t count) {
  std::vector<Vec3> all;
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
    all.insert(all.end(), {axis, -axis});
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double up = 1 - 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double level = std::sqrt(1 - up * up), turn = golden * static_cast<double>(i);
    all.emplace_back(level * math::cos(turn), up, level * math::sin(turn));
  }
  return all;
}

void limit_motors(DeviceDesc& device, double limit) {
  for (ArmDesc& arm : device.mechanism.arms)
    for (JointDesc& joint : arm.joints) joint.max_torque = limit;
}

HardnessStudy study_hardness(const std::string& name, const DeviceDesc& device, const StrikeSetting& setting,
                             const HardnessProgress& progress) {
  HardnessStudy study;
  study.device = name;
  study.title = device.name;
  study.setting = setting;
  const Actuators motors(device);
  study.renders_torque = device.renders_torque;
  study.spare_motors = motors.count() > motors.rows();
  study.max_force = device.max_force;
  study.max_torque = device.max_torque;
  for (int m = 0; m < motors.count(); ++m)
    study.limits.emplace_back(Actuators::name(device, m), motors.limits()[m]);
  study.stylus_D = stylus_of(device);

  progress("Directions and angles", 0);
  HardnessSurvey at(device, setting);
  study.rows = at.rows_at_home(kUsableMethods, kPhis);
  for (const PulseMethod method :
       {PulseMethod::force_only, PulseMethod::force_only_spare, PulseMethod::algorithm1, PulseMethod::exact})
    study.in_the_tick.push_back(at.in_the_tick(method));
  for (const PulseMethod method : {PulseMethod::force_only, PulseMethod::force_only_spare,
                                   PulseMethod::algorithm1, PulseMethod::exact}) {
    study.means.push_back(at.over_directions(method));
    if (study.stylus_D) study.along_stylus.push_back(at.along_stylus(method, *study.stylus_D));
  }
  for (const double speed : {setting.speed, 0.1 * setting.speed}) {
    StrikeSetting slower = setting;
    slower.speed = speed;
    HardnessSurvey there(device, slower);
    for (const PulseMethod method :
         {PulseMethod::exact, PulseMethod::nearest_wrench, PulseMethod::free_moment})
      study.shown.push_back(there.shown(method));
  }
  for (const double phi_deg : {0.0, 15.0, 30.0, 45.0, 60.0, 90.0}) {
    for (const bool all_tilts : {false, true})
      for (const PulseMethod method : {PulseMethod::algorithm1, PulseMethod::exact})
        study.maps.push_back(at.map(method, phi_deg, all_tilts));
    progress("The map", phi_deg / 90);
  }
  for (const double speed : {setting.speed, 0.3 * setting.speed, 0.1 * setting.speed}) {
    StrikeSetting slower = setting;
    slower.speed = speed;
    HardnessSurvey there(device, slower);
    for (const PulseMethod method : {PulseMethod::force_only, PulseMethod::force_only_spare,
                                     PulseMethod::algorithm1, PulseMethod::exact})
      study.angles.push_back(there.over_angles(method));
  }
  for (double lean_deg = 0; lean_deg <= 360; lean_deg += 3) study.leans.push_back(at.lean(lean_deg));

  const auto place = [](std::size_t i, std::size_t count) {
    return kReach * (2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1);
  };
  for (std::size_t y = 0; y < kLayers; ++y) {
    progress("Poses", static_cast<double>(y) / kLayers);
    for (std::size_t z = 0; z < kPosesAcross; ++z) {
      for (std::size_t x = 0; x < kPosesAcross; ++x) {
        const Vec3 p_DH = device.workspace.cwiseProduct(
            Vec3(place(x, kPosesAcross), place(y, kLayers), place(z, kPosesAcross)));
        study.poses.push_back(at.pose(p_DH));
        if (!study.poses.back().reached || p_DH.isZero(kNothing)) continue;
        for (const PulseMethod method : kUsableMethods)
          for (const Vec3& nhat_D : directions(0))
            study.rows.push_back(at.row(method, {Quat::Identity(), p_DH}, position_text(p_DH), nhat_D, kPhi));
      }
    }
  }
  const std::pair<const char*, Vec3> sides[] = {{"up", {0, 1, 0}},
                                                {"to the right", {1, 0, 0}},
                                                {"towards the person", {0, 0, 1}},
                                                {"up and towards the person", {0, 1, 1}}};
  for (const auto& [side, nhat_D] : sides) study.fronts.push_back(at.front(side, nhat_D));
  if (study.stylus_D) {
    // Either way along an axis is the same; the one on whose side the grasp is can be struck.
    for (const auto& [side, other, nhat_D] :
         {std::tuple{"up", "down", Vec3(0, 1, 0)}, std::tuple{"right", "left", Vec3(1, 0, 0)},
          std::tuple{"to the person", "away", Vec3(0, 0, 1)}}) {
      const bool turn = nhat_D.dot(*study.stylus_D) < -kNothing;
      study.axes.push_back(at.axis(turn ? other : side, turn ? Vec3(-nhat_D) : nhat_D, *study.stylus_D));
    }
  }
  progress("Random pulses", 0);
  study.checks = check_pulses(device);
  return study;
}

}  // namespace fulcrum::analysis::hardness
