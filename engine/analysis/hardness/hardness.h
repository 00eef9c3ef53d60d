#pragma once
// The study of `fulcrum hardness`: where, on one device, a moment beside a braking pulse makes a surface feel
// harder than the force alone, and where it cannot.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/analysis/hardness/pulse_checks.h"
#include "engine/analysis/hardness/strike.h"

namespace fulcrum::analysis::hardness {

inline constexpr double kPhi = 45;  // deg, of the paper's study: where only one angle is looked at
inline constexpr std::array kPhis{0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0};  // deg
inline constexpr std::size_t kDirections = 200, kPoseDirections = 48;        // beside the axes
inline constexpr const char* kHome = "home";

// A row of hardness.csv.
struct HardnessRow {
  PulseMethod method = PulseMethod::none;
  std::string pose;  // of the handle in D: kHome, or its position, "x y z" in m
  Vec3 nhat_D = Vec3::UnitY();
  double phi_deg = 0;  // leaning towards the person
  PulseOutcome felt;
  double rate_hardness = 0;       // N/m, extended: of the force, as published
  double felt_rate_hardness = 0;  // N/m, of the contact force that would feel as strong
};

// What a method gives over force only.
struct Gain {
  double moment = 1;    // of the felt moment
  double hardness = 1;  // of the contact force that would feel as strong
};
Gain gain_over(const PulseOutcome& felt, const PulseOutcome& force_only, double phi, double lever);

// Surfaces that face up, seen from above: (kAcross x kAcross) cells of a disc, row by row from the top, which
// is away from the person; equal areas. Cells outside of it are empty. The lower half is the same: where
// force and moment change sign together, the motors' efforts do.
inline constexpr std::size_t kAcross = 25;
struct DirectionMap {
  PulseMethod method = PulseMethod::exact;
  double phi_deg = 0;
  bool all_tilts = false;  // the mean over eight leans; else towards the person
  std::vector<std::optional<Gain>> cells;
};
std::optional<Vec3> sky_direction(std::size_t cell);  // (3) unit; of a cell that the rim cuts, on the rim

// Over angles: means over directions, leaning towards the person.
struct AngleCurve {
  PulseMethod method = PulseMethod::exact;
  double speed = 0;  // m/s
  struct At {
    double phi_deg, felt_moment;  // deg, N m
    Gain gain;
  };
  std::vector<At> at;
};

// Over the side to which the stylus leans, for a surface that faces up.
struct TiltSample {
  double lean_deg = 0;
  PulseOutcome force_only, as_printed, algorithm1, exact;
};

// Handle positions over the workspace, at its axes at home: means over directions at kPhi.
struct PoseAt {
  Vec3 p_DH = Vec3::Zero();  // (3) m
  bool reached = false;
  Gain algorithm1, exact, spare;
};
inline constexpr std::size_t kPosesAcross = 5, kLayers = 3;  // over x and z; over y

// The front between force and moment for one direction: `exact` at a weight of the moment.
struct FrontAt {
  double weight = 0, force = 0, moment = 0;  // 1, N, N m
};
struct Front {
  std::string name;
  std::vector<FrontAt> at;
  PulseOutcome force_only, algorithm1, exact;
};

// The paper's pose: home, the grasp where the stylus is.
struct PaperAxis {
  std::string name;
  Vec3 nhat_D = Vec3::UnitY();
  double phi = 0, lean = 0;  // rad
  PulseOutcome force_only, as_printed, algorithm1, exact;
};

// What the methods that are not used do, beside `exact`: over directions at home, at kPhi.
struct ShownMethod {
  PulseMethod method = PulseMethod::exact;
  double speed = 0;                   // m/s
  double force = 0;                   // N, along the normal, mean
  double tilt = 0, largest_tilt = 0;  // rad, of the force from the normal: mean, largest
  double turned = 0;                  // rad, of the felt moment from the contact's own: mean
  double largest_moment = 0;          // of the contact's own
};

// A method as the tick allocates it, within what the device's file gives for the whole: means over directions
// at home, at kPhi.
struct TickMethod {
  PulseMethod method = PulseMethod::exact;
  double force = 0, moment = 0;  // N, N m felt
  Gain gain;                     // over force only, in the tick too
  double cut = 0;                // part of the directions in which that takes something away
};

// Means over very many directions at home: the rows' own are a sample of them.
inline constexpr std::size_t kManyDirections = 20000;
struct DirectionMeans {
  PulseMethod method = PulseMethod::exact;
  double force = 0, moment = 0;       // N, N m felt
  double gain = 1, largest_gain = 1;  // of felt moment over force only
  double helped = 0, lowered = 0;     // parts of the directions: gain above, below 1 by more than kNoticed
};
inline constexpr double kNoticed = 0.02;  // of the felt moment: a smaller gain or loss counts as none

struct HardnessStudy {
  std::string device, title;  // as its file is called; as it calls itself
  std::string command;        // that makes it again
  StrikeSetting setting;
  bool renders_torque = false;
  bool spare_motors = false;                           // more than a wrench has rows
  double max_force = 0, max_torque = 0;                // N, N m: of the device as a whole
  std::vector<std::pair<std::string, double>> limits;  // of the motors, N or N m
  std::optional<Vec3> stylus_D;  // (3) unit, at home, from H to the grasp, where the device says so
  std::vector<HardnessRow> rows;
  std::vector<TickMethod> in_the_tick;
  std::vector<DirectionMeans> means;         // at kPhi, leaning towards the person
  std::vector<DirectionMeans> along_stylus;  // with the grasp along stylus_D; empty without one
  std::vector<ShownMethod> shown;
  std::vector<DirectionMap> maps;
  std::vector<AngleCurve> angles;
  std::vector<TiltSample> leans;
  std::vector<PoseAt> poses;  // x fastest, then z, then y
  std::vector<Front> fronts;
  std::vector<PaperAxis> axes;
  PulseChecks checks;
};

// An even spread over the sphere (a Fibonacci lattice; R. Swinbank, R. J. Purser, "Fibonacci grids", 2006),
// and the axes before it.
std::vector<Vec3> directions(std::size_t count);

// All motors of a device's arms at one limit, N m.
void limit_motors(DeviceDesc& device, double limit);

using HardnessProgress = std::function<void(std::string_view what, double fraction)>;
HardnessStudy study_hardness(const std::string& name, const DeviceDesc& device, const StrikeSetting& setting,
                             const HardnessProgress& progress);

}  // namespace fulcrum::analysis::hardness
