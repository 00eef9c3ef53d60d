#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "engine/app/author/first_text.h"
#include "engine/app/author/path_fit.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/prepare/prepare.h"
#include "engine/files/put_file.h"
#include "engine/record/motion.h"
#include "haptics/math/mirror.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

struct PathOptions {
  std::string scenario, run;
  std::string out = "expert.yaml";
  double tolerance_mm = 0.5;
  bool force = false;
};

// Of the tolerance: 0.5 mm goes with the angle that moves a point 25 mm from the tool's origin so far.
constexpr double kAngle_rad_of_mm = 0.04;
constexpr double kDegrees = 180 / std::numbers::pi;

// What the hand wanted of the tool's model, as a path's file has it: of the right hand, without what a hand
// aims higher for the tool's weight.
std::vector<Pose> wanted(const Prepared& prepared, const record::HandleMotion& motion) {
  const bool left = prepared.scenario.left_handed;
  const Vec3 sag_W(0, sag(prepared.haptic.scene), 0);
  std::vector<Pose> poses;
  for (const DeviceSample& sample : motion.samples) {
    Pose& X_WM = poses.emplace_back(sample.X_DH * prepared.scenario.tool.X_HM);
    X_WM.p -= sag_W;
    if (left) mirror(X_WM);
  }
  return poses;
}

std::string text_of(const FittedPath& fitted) {
  char line[256];
  std::snprintf(line, sizeof line,
                "# Recorded; within %.2g mm and %.2g degrees of it. `fulcrum path` wrote it.\n",
                1e3 * fitted.position_error, kDegrees * fitted.angle_error_rad);
  std::string text = schema_line(schema_folder(), "hand") + "fulcrum: 1\n" + line + "waypoints:\n";
  for (const Waypoint& waypoint : fitted.waypoints) {
    const Pose& X = waypoint.X_WT;
    std::snprintf(line, sizeof line,
                  "  - {position: [%.6f, %.6f, %.6f], orientation: [%.6f, %.6f, %.6f, %.6f]", X.p.x(),
                  X.p.y(), X.p.z(), X.q.w(), X.q.x(), X.q.y(), X.q.z());
    text += line;
    if (&waypoint != fitted.waypoints.data()) {
      std::snprintf(line, sizeof line, ", travel: %.4g", waypoint.travel);
      text += line;
    }
    if (waypoint.dwell > 0) {
      std::snprintf(line, sizeof line, ", dwell: %.4g", waypoint.dwell);
      text += line;
    }
    text += waypoint.through ? ", through: true}\n" : "}\n";
  }
  return text;
}

int path_command(const PathOptions& options) {
  std::error_code ignored;
  if (!options.force && fs::exists(fs::symlink_status(options.out, ignored))) {
    complain(options.out + " is there already: --force replaces it.");
    return kError;
  }
  const std::optional<Prepared> prepared = prepare(options.scenario, std::vector<std::string>());
  if (!prepared) return kError;
  const fs::path run(options.run);
  const fs::path trace = fs::is_directory(run, ignored) ? run / "trace.csv" : run;
  const Result<record::HandleMotion> motion = record::read_motion(trace);
  if (!motion) {
    complain(motion.error().sentence);
    return kError;
  }
  if (motion->space != record::HandleMotion::Space::scene) {
    complain(trace.string() +
             " is a tape, which has the device's motion: name the run's folder, or its trace.csv.");
    return kError;
  }
  const std::vector<Pose> poses = wanted(*prepared, *motion);
  const FittedPath fitted = fit_path(
      poses, motion->tick_s,
      {.position = 1e-3 * options.tolerance_mm, .angle_rad = kAngle_rad_of_mm * options.tolerance_mm});
  const std::string text = text_of(fitted);
  if (!put_file(options.out, {std::as_bytes(std::span(text))})) {
    complain(options.out + " cannot be written: see that its folder is yours and has room.");
    return kError;
  }
  std::printf(
      "%s: %zu waypoints for %.1f s, within %.2g mm and %.2g degrees of what was done; %.1f s of rest at the "
      "start "
      "left out\n",
      bold(options.out).c_str(), fitted.waypoints.size(), motion->tick_s * static_cast<double>(poses.size()),
      1e3 * fitted.position_error, kDegrees * fitted.angle_error_rad, fitted.trimmed_start);
  if (fitted.position_error > 1e-3 * options.tolerance_mm)
    complain("what was done trembles by more than the tolerance: nothing is gained by one so small.");
  return kCompleted;
}

}  // namespace

void add_path(Program& program) {
  const auto options = std::make_shared<PathOptions>();
  program.add(
      "path", "Make a hand's path of a run: the expert's way, by doing it",
      [options](Arguments& arguments) {
        arguments.required({"scenario", "NAME|FILE", "The scenario that was run"}, options->scenario);
        arguments.required({"run", "DIR", "The folder that the run left, or its trace.csv"}, options->run);
        arguments.text({"--out", "FILE", "The file to write (default: expert.yaml)"}, options->out);
        arguments.number(
            {"--tolerance", "MM", "How far the path may be from what was done (default: 0.5 mm)"},
            options->tolerance_mm, 0.01, 100);
        arguments.flag("--force", "Replace the file if it is there", options->force);
      },
      [options] { return path_command(*options); });
}

}  // namespace fulcrum::app
