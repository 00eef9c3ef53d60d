#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/analysis/hardness/report.h"
#include "engine/analysis/hardness/tables.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/named_device.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/studies/commands.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

// Of `run` count out, force and json.
struct HardnessOptions {
  RunOptions run;
  std::string device = "w6d";
  double speed = 0.15;                // m/s
  std::optional<double> motor_limit;  // N m, of every motor of an arm
};

using Json = nlohmann::ordered_json;

Json to_json(const analysis::hardness::MethodSummary& s) {
  return {{"method", analysis::hardness::name_of(s.method)},
          {"phi_deg", s.phi_deg},
          {"felt_force_N", s.force},
          {"felt_moment_Nm", s.moment},
          {"extended_rate_hardness_N_per_m", s.rate_hardness},
          {"felt_rate_hardness_N_per_m", s.felt_rate_hardness},
          {"moment_gain", s.gain.moment},
          {"felt_hardness_gain", s.gain.hardness},
          {"least_moment_gain", s.least_gain},
          {"largest_moment_gain", s.largest_gain},
          {"helped", s.helped},
          {"lowered", s.lowered}};
}

Json checks_json(const analysis::hardness::PulseChecks& checks) {
  Json costs = Json::array();
  for (const analysis::hardness::MethodCost& cost : checks.costs)
    costs.push_back({{"method", analysis::hardness::name_of(cost.method)},
                     {"missing", cost.missing},
                     {"median_us", cost.median_us},
                     {"p99_us", cost.p99_us}});
  return {{"cases", checks.cases},
          {"clamped", checks.clamped},
          {"out_of_reach", checks.beyond},
          {"worst_margin", checks.worst_margin},
          {"better", checks.better},
          {"largest_load", checks.largest_load},
          {"costs", costs}};
}

Json axes_json(const analysis::hardness::HardnessStudy& study) {
  Json axes = Json::array();
  for (const analysis::hardness::PaperAxis& axis : study.axes)
    axes.push_back({{"faces", axis.name},
                    {"phi_rad", axis.phi},
                    {"gamma", axis.algorithm1.gamma},
                    {"delta", axis.algorithm1.delta()},
                    {"felt_moment_Nm", axis.algorithm1.moment_D.norm()},
                    {"felt_moment_as_printed_Nm", axis.as_printed.moment_D.norm()},
                    {"felt_moment_exact_Nm", axis.exact.moment_D.norm()},
                    {"force_exact_N", axis.exact.force}});
  return axes;
}

Json means_json(const std::vector<analysis::hardness::DirectionMeans>& means) {
  Json list = Json::array();
  for (const analysis::hardness::DirectionMeans& m : means)
    list.push_back({{"method", analysis::hardness::name_of(m.method)},
                    {"felt_force_N", m.force},
                    {"felt_moment_Nm", m.moment},
                    {"moment_gain", m.gain},
                    {"largest_moment_gain", m.largest_gain},
                    {"helped", m.helped},
                    {"lowered", m.lowered}});
  return list;
}

Json to_json(const analysis::hardness::HardnessStudy& study) {
  Json methods = Json::array();
  for (const analysis::hardness::PulseMethod method : analysis::hardness::kUsableMethods)
    for (const double phi_deg : analysis::hardness::kPhis)
      methods.push_back(to_json(analysis::hardness::summary_of(study, method, phi_deg)));
  Json in_the_tick = Json::array();
  for (const analysis::hardness::TickMethod& t : study.in_the_tick)
    in_the_tick.push_back({{"method", analysis::hardness::name_of(t.method)},
                           {"felt_force_N", t.force},
                           {"felt_moment_Nm", t.moment},
                           {"moment_gain", t.gain.moment},
                           {"felt_hardness_gain", t.gain.hardness},
                           {"cut", t.cut}});
  Json shown = Json::array();
  for (const analysis::hardness::ShownMethod& s : study.shown)
    shown.push_back({{"method", analysis::hardness::name_of(s.method)},
                     {"speed_m_per_s", s.speed},
                     {"felt_force_N", s.force},
                     {"tilt_rad", s.tilt},
                     {"largest_tilt_rad", s.largest_tilt},
                     {"turned_rad", s.turned},
                     {"largest_moment_of_contact", s.largest_moment}});
  const analysis::hardness::StrikeSetting& s = study.setting;
  return {{"device", study.device},
          {"hand_mass_kg", s.hand_mass},
          {"speed_m_per_s", s.speed},
          {"pulse_ticks", s.ticks},
          {"tick_s", s.tick_s},
          {"lever_m", s.lever},
          {"stiffness_N_per_m", s.stiffness},
          {"wanted_force_N", s.wanted_force()},
          {"answer", analysis::hardness::hardness_answer(study)},
          {"methods", methods},
          {"many_directions", means_json(study.means)},
          {"along_stylus", means_json(study.along_stylus)},
          {"in_the_tick", in_the_tick},
          {"shown_not_used", shown},
          {"paper_axes", axes_json(study)},
          {"checks", checks_json(study.checks)}};
}

int hardness_command(const HardnessOptions& options) {
  constexpr std::string_view files[] = {analysis::hardness::kHardnessCsvName,
                                        analysis::hardness::kHardnessJsonName,
                                        analysis::hardness::kHardnessPageName};
  std::optional<DeviceDesc> device = pushing_device_named(options.device);
  if (!device) return kError;
  std::string command = "fulcrum hardness --device " + options.device;
  analysis::hardness::StrikeSetting setting;
  setting.speed = options.speed;
  if (options.speed != HardnessOptions{}.speed) command += " --speed " + number_text(options.speed, 6);
  if (options.motor_limit) {
    if (device->kinematics != Kinematics::arms) {
      complain("the device '" + options.device + "' has no arms: --motor-limit is of an arm's motors.");
      return kError;
    }
    analysis::hardness::limit_motors(*device, *options.motor_limit);
    command += " --motor-limit " + number_text(*options.motor_limit, 6);
  }
  const auto place = report_place("hardness", options.run, files);
  if (!place) return kError;
  ProgressBar bar;
  analysis::hardness::HardnessStudy study = analysis::hardness::study_hardness(
      options.device, *device, setting,
      [&bar](std::string_view what, double fraction) { bar.show(what, fraction); });
  bar.clear();
  study.command = command;
  const std::string json = to_json(study).dump(2) + "\n";
  const auto folder = write_report(
      *place, {{analysis::hardness::kHardnessCsvName, analysis::hardness::hardness_csv(study).text()},
               {analysis::hardness::kHardnessJsonName, json},
               {analysis::hardness::kHardnessPageName, analysis::hardness::hardness_page(study).html()}});
  if (!folder) return kError;
  if (options.run.json) {
    std::printf("%s", json.c_str());
    return kCompleted;
  }
  for (const std::string& sentence : analysis::hardness::hardness_answer(study))
    std::printf("%s\n", sentence.c_str());
  print_table(analysis::hardness::method_table(study));
  std::printf("Map, plots and every direction lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace

void add_hardness(Program& program) {
  const auto options = std::make_shared<HardnessOptions>();
  program.add(
      kHardnessStudy.name, kHardnessStudy.about,
      [options](Arguments& arguments) {
        arguments.text({"--device", "NAME", "A file of content/devices, by name (default: w6d)"},
                       options->device);
        arguments.number({"--speed", "V", "Of the hand towards the surface, in m/s (default 0.15)"},
                         options->speed, 1e-3, 10);
        arguments.number({"--motor-limit", "LIMIT",
                          "Of every motor of the device's arms, in N m (default: as its file says)"},
                         options->motor_limit, 1e-3, 1e3);
        arguments.out(options->run);
        arguments.json("Print hardness.json", options->run.json);
      },
      [options] { return hardness_command(*options); });
}

}  // namespace fulcrum::app
