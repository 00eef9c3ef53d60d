#include "engine/analysis/hardness/pulse_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "haptics/loop/run_tick.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"

namespace fulcrum::analysis::hardness {
namespace {

constexpr double kReached = 1e-6;     // m
constexpr double kTickMotion = 1e-4;  // m, of a hand in a tick: the arms are found from where they were

Vec3 random_vector(SplitMix& random) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return 2 * Vec3(x, y, z) - Vec3::Ones();
}

struct Case {
  Pose X_DH;
  Vec3 step, f_D, p_HG_D;
};

Case random_case(const DeviceDesc& device, SplitMix& random) {
  Case c;
  c.X_DH.q = quaternion_exp(0.4 * random_vector(random));
  c.X_DH.p = device.workspace.cwiseProduct(random_vector(random));
  c.step = kTickMotion * random_vector(random).normalized();
  const double size = math::exp(8 * random.uniform() - 3);
  c.f_D = size * random_vector(random).normalized();
  c.p_HG_D = 0.2 * random.uniform() * random_vector(random).normalized();
  return c;
}

// Squared, N^2: what is missing of a force and of the moment that a hand was to feel, in units of its lever.
double missing_squared(const Wrench& F_H_D, const Case& c) {
  const Vec3 whole = c.p_HG_D.cross(c.f_D), felt = c.p_HG_D.cross(F_H_D.force) - F_H_D.torque;
  return (c.f_D - F_H_D.force).squaredNorm() + (whole - felt).squaredNorm() / c.p_HG_D.squaredNorm();
}

double wanted_squared(const Case& c) {
  return c.f_D.squaredNorm() + c.p_HG_D.cross(c.f_D).squaredNorm() / c.p_HG_D.squaredNorm();
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

struct Candidate {
  PulseMethod method;
  Allocator motors;
  double missing = 0;  // sum over the clamped cases
  std::vector<double> us{};
};

double largest_load(const Allocator& motors) {
  double largest = 0;
  for (int m = 0; m < motors.motors(); ++m)
    if (const double limit = motors.actuators().limits()[m]; limit > 0)
      largest = std::max(largest, std::abs(motors.taken()[m]) / limit);
  return largest;
}

}  // namespace

PulseChecks check_pulses(const DeviceDesc& device, std::size_t cases) {
  std::vector<Candidate> candidates;
  for (const auto& [method, by] : {std::pair{PulseMethod::force_only, AllocationMethod::pseudoinverse},
                                   std::pair{PulseMethod::force_only_spare, AllocationMethod::exact},
                                   std::pair{PulseMethod::algorithm1, AllocationMethod::algorithm1},
                                   std::pair{PulseMethod::exact, AllocationMethod::exact}})
    candidates.push_back({method, Allocator(device, {.method = by, .moment_weight = 1})});
  std::optional<Mechanism> arms;
  if (device.kinematics == Kinematics::arms) arms.emplace(device.mechanism);
  PulseChecks checks;
  checks.cases = cases;
  checks.worst_margin = -1;
  SplitMix random(1);
  for (std::size_t i = 0; i < cases; ++i) {
    const Case c = random_case(device, random);
    const double wanted = wanted_squared(c);
    if (arms) arms->follow(c.X_DH);
    const bool reached = !arms || arms->out_of_reach() < kReached;
    if (!reached) ++checks.beyond;
    std::vector<double> missing;
    bool clamped = false;
    for (Candidate& each : candidates) {
      each.motors.begin({c.X_DH.q, c.X_DH.p - c.step});
      const std::int64_t before = thread_cpu_ns();
      each.motors.begin(c.X_DH);
      const Allocation given = each.method == PulseMethod::force_only_spare
                                   ? each.motors.allocate_uniform({c.f_D, Vec3::Zero()})
                                   : each.motors.pulse({c.f_D, Vec3::Zero()}, c.p_HG_D, c.p_HG_D.norm());
      const double us = static_cast<double>(thread_cpu_ns() - before) * 1e-3;
      if (reached) each.us.push_back(us);
      each.motors.reserve(given);
      missing.push_back(missing_squared(given.F_H_D, c) / wanted);
      checks.largest_load = std::max(checks.largest_load, largest_load(each.motors));
      clamped |= each.method == PulseMethod::force_only && given.force_share < 1;
    }
    if (!clamped) continue;
    ++checks.clamped;
    for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k].missing += std::sqrt(missing[k]);
    const double others = std::min(missing[0], missing[2]), by_exact = missing[3];
    checks.worst_margin = std::max(checks.worst_margin, by_exact - others);
    if (by_exact < 0.999 * others) ++checks.better;
  }
  for (const Candidate& each : candidates)
    checks.costs.push_back({each.method,
                            checks.clamped > 0 ? each.missing / static_cast<double>(checks.clamped) : 0.0,
                            quantile(each.us, 0.5), quantile(each.us, 0.99)});
  return checks;
}

}  // namespace fulcrum::analysis::hardness
