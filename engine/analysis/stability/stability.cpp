#include "engine/analysis/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/analysis/simulated_wall.h"
#include "haptics/bake/parallel.h"
#include "haptics/device/linear_loop.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::stability {
namespace {

WallLoop loop_of(const NamedAxis& device, int delay_ticks = 0) {
  return {.axis = device.axis, .tick_s = kStudyTick, .delay_ticks = delay_ticks};
}

std::vector<double> evenly(double low, double high, int steps) {
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) values.push_back(low + (high - low) * i / steps);
  return values;
}

std::vector<double> geometrically(double low, double high, int steps) {
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) values.push_back(low * math::pow(high / low, double(i) / steps));
  return values;
}

// None; evenly where the device's own damping counts; by ratios up to almost all that is stable without
// delay.
std::set<double> damping_of(const NamedAxis& device) {
  constexpr double almost = 0.98;
  const double own = device.axis.damping;
  std::set<double> all;
  for (const double B : geometrically(own / 20, own / 4, 3)) all.insert(B);
  for (const double B : evenly(0, 5 * own, 10)) all.insert(B);
  for (const double B : geometrically(6 * own, almost * exact_damping_limit(loop_of(device)), 16))
    all.insert(B);
  return all;
}

std::vector<Border> borders_of(const NamedAxis& device, const std::function<void(double)>& progress) {
  std::vector<Border> borders;
  for (int delay = 0; delay < kStudyDelays; ++delay)
    for (const double B : damping_of(device)) borders.push_back({device.name, delay, B, 0, 0, 0});
  for_each_piece(
      borders.size(), 0,
      [&](std::size_t i) {
        Border& border = borders[i];
        const WallLoop loop = loop_of(device, border.delay_ticks);
        border.K_simulated = simulated_stiffness_limit(loop, border.B, kStudySpeed);
        border.K_exact = exact_stiffness_limit(loop, border.B);
        border.K_passive = passive_stiffness_limit(loop, border.B);
      },
      progress);
  return borders;
}

GrowthMap growth_map(const NamedAxis& device) {
  GrowthMap map{evenly(0, 2.5, 50), evenly(0, 6000, 48), {}};
  for (std::size_t j = 0; j + 1 < map.K_edges.size(); ++j) {
    for (std::size_t i = 0; i + 1 < map.B_edges.size(); ++i) {
      const Wall wall{(map.K_edges[j] + map.K_edges[j + 1]) / 2, (map.B_edges[i] + map.B_edges[i + 1]) / 2};
      map.growth.push_back(swing(loop_of(device), wall, kStudySpeed).growth);
    }
  }
  return map;
}

std::vector<TickLimit> tick_limits(const NamedAxis& device) {
  std::vector<TickLimit> limits;
  for (const double tick_s : {1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 6e-2}) {
    WallLoop loop = loop_of(device);
    loop.tick_s = tick_s;
    limits.push_back({tick_s, simulated_stiffness_limit(loop, 0, kStudySpeed), exact_stiffness_limit(loop, 0),
                      passive_stiffness_limit(loop, 0)});
  }
  return limits;
}

std::vector<SpeedLimit> speed_limits(const NamedAxis& device) {
  std::vector<SpeedLimit> limits;
  if (device.axis.linear()) return limits;
  for (const double v0 : geometrically(0.01, 1, 16))
    limits.push_back({v0, simulated_stiffness_limit(loop_of(device), 0, v0)});
  return limits;
}

Outcome outcome_of(const WallLoop& loop, double K) {
  constexpr double slow = 5, fast = 2000;  // encoder counts of undamped swing
  constexpr double still = 1e-3;           // encoder counts: what moves within them is at rest
  const double step = loop.axis.encoder_step, w = std::sqrt(K / loop.axis.mass);
  const Swing from_slow = swing(loop, {K, 0}, slow * step * w);
  const Swing from_fast = swing(loop, {K, 0}, fast * step * w);
  if (from_fast.late >= from_fast.early)
    return from_slow.late < from_slow.early ? Outcome::settles_if_slow : Outcome::grows;
  return std::max(from_slow.late, from_fast.late) <= still * step ? Outcome::settles : Outcome::trembles;
}

DiolaitiMap diolaiti_map() {
  constexpr double K = 1000, step = 28e-6;  // only their ratios to b and f_c count
  DiolaitiMap map{geometrically(0.02, 5, 24), geometrically(0.02, 5, 24), {}};
  for (std::size_t j = 0; j + 1 < map.sigma_edges.size(); ++j) {
    for (std::size_t i = 0; i + 1 < map.beta_edges.size(); ++i) {
      const double beta = std::sqrt(map.beta_edges[i] * map.beta_edges[i + 1]);
      const double sigma = std::sqrt(map.sigma_edges[j] * map.sigma_edges[j + 1]);
      const DeviceAxis axis{.mass = kReferenceMass,
                            .damping = beta * K * kStudyTick,
                            .friction = sigma * K * step,
                            .encoder_step = step};
      map.outcome.push_back(outcome_of({.axis = axis, .tick_s = kStudyTick}, K));
    }
  }
  return map;
}

}  // namespace

NamedAxis reference_axis() {
  return {"reference", {.mass = kReferenceMass, .damping = kReferenceDamping}};
}

NamedAxis linear_twin(const NamedAxis& device) {
  return {device.name + " linear", {.mass = device.axis.mass, .damping = device.axis.damping}};
}

std::vector<ZWidth> z_widths(const std::vector<Border>& borders) {
  std::vector<ZWidth> widths;
  for (const Border& border : borders) {
    if (widths.empty() || widths.back().device != border.device ||
        widths.back().delay_ticks != border.delay_ticks)
      widths.push_back({border.device, border.delay_ticks, border, border, border});
    ZWidth& width = widths.back();
    if (border.K_simulated > width.simulated.K_simulated) width.simulated = border;
    if (border.K_exact > width.exact.K_exact) width.exact = border;
    if (border.K_passive > width.passive.K_passive) width.passive = border;
  }
  return widths;
}

StabilityStudy study_stability(const std::vector<NamedAxis>& models, const StudyProgress& progress) {
  StabilityStudy study;
  const NamedAxis reference = reference_axis();
  study.devices.push_back(reference);
  for (const NamedAxis& model : models) {
    if (!model.axis.linear()) study.devices.push_back(linear_twin(model));
    study.devices.push_back(model);
  }
  for (const NamedAxis& device : study.devices) {
    const std::string what = "Borders of " + device.name;
    const std::vector<Border> borders =
        borders_of(device, [&](double fraction) { progress(what, fraction); });
    study.borders.insert(study.borders.end(), borders.begin(), borders.end());
    study.speeds.push_back(speed_limits(device));
  }
  progress("Growth rates", 0);
  study.growth = growth_map(reference);
  progress("Ticks", 0);
  study.ticks = tick_limits(reference);
  progress("Friction and encoder counts", 0);
  study.diolaiti = diolaiti_map();
  for (const Wall& wall : {Wall{900, 0}, Wall{1100, 0}, Wall{600, 0.25}, Wall{4000, 2}})
    study.energies.push_back({wall, port_energy(loop_of(reference), wall, kStudySpeed, 500)});
  return study;
}

}  // namespace fulcrum::analysis::stability
