#pragma once
// The study of `fulcrum stability`: how stiff a wall a device can hold, simulated and by theory.

#include <functional>
#include <string>
#include <vector>

#include "engine/analysis/stability/passivity.h"
#include "haptics/device/wall_loop.h"

namespace fulcrum::analysis::stability {

inline constexpr double kStudyTick = 1e-3;        // s
inline constexpr double kStudySpeed = 0.1;        // m/s, at which a device that is not linear meets the wall
inline constexpr int kStudyDelays = 3;            // 0, 1, 2 ticks
inline constexpr double kReferenceMass = 0.1;     // kg
inline constexpr double kReferenceDamping = 0.5;  // N s/m

struct NamedAxis {
  std::string name;
  DeviceAxis axis;
};

// A linear device of round figures, which theory describes whole.
NamedAxis reference_axis();
// The same without friction and encoder counts.
NamedAxis linear_twin(const NamedAxis& device);

struct Border {
  std::string device;
  int delay_ticks = 0;
  double B = 0;            // N s/m
  double K_simulated = 0;  // N/m, where the simulated device ceases to settle from kStudySpeed
  double K_exact = 0;      // N/m, of the linear loop: without friction and encoder counts
  double K_passive = 0;    // N/m
};

// Z-width: the stiffest wall over all damping that was tried.
struct ZWidth {
  std::string device;
  int delay_ticks = 0;
  Border simulated, exact, passive;  // where each has its largest K
};
std::vector<ZWidth> z_widths(const std::vector<Border>& borders);

// (m x n) growth rates in 1/s of simulated swings of the reference, no delay, at the middles of cells.
struct GrowthMap {
  std::vector<double> B_edges, K_edges;
  std::vector<double> growth;  // row j by row: K
};

struct TickLimit {
  double tick_s, K_simulated, K_exact, K_passive;  // the reference, no damping, no delay
};

struct SpeedLimit {
  double v0, K_simulated;  // m/s, N/m
};

enum class Outcome { settles, trembles, settles_if_slow, grows };

// Simulated outcomes over Diolaiti's plane, from a slow and a fast start.
struct DiolaitiMap {
  std::vector<double> beta_edges, sigma_edges;
  std::vector<Outcome> outcome;  // row j by row: sigma
};

struct EnergyRun {
  Wall wall;
  std::vector<double> energy;  // J, after each tick
};

struct StabilityStudy {
  std::vector<NamedAxis> devices;  // the first is the reference
  std::vector<Border> borders;
  GrowthMap growth;
  std::vector<TickLimit> ticks;
  std::vector<std::vector<SpeedLimit>> speeds;  // of each device; empty for a linear one
  DiolaitiMap diolaiti;
  std::vector<EnergyRun> energies;  // of the reference
};

// The reference, and each of `models` with its linear twin before it: about ten seconds of a processor for
// each.
using StudyProgress = std::function<void(std::string_view what, double fraction)>;
StabilityStudy study_stability(const std::vector<NamedAxis>& models, const StudyProgress& progress);

}  // namespace fulcrum::analysis::stability
