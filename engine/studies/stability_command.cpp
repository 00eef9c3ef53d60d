#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/analysis/stability/report.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/named_device.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/studies/commands.h"
#include "haptics/actuation/actuators.h"

namespace fulcrum::app {
namespace {

analysis::stability::NamedAxis axis_of(const std::string& name, const DeviceDesc& device) {
  return {name,
          {.mass = device.handle_mass,
           .damping = device.damping,
           .friction = device.friction,
           .encoder_step = device.encoder_step}};
}

// The device of that name, or, without one, each device file of a device that has motors; what is wrong with
// one is said, and nothing is returned.
std::optional<std::vector<analysis::stability::NamedAxis>> device_axes(const std::string& only) {
  std::vector<analysis::stability::NamedAxis> axes;
  if (!only.empty()) {
    const std::optional<DeviceDesc> device = pushing_device_named(only);
    if (!device) return std::nullopt;
    return std::vector{axis_of(only, *device)};
  }
  for (const auto& [name, file] : scenario::device_files(scenario::content_roots())) {
    const scenario::Checked<DeviceDesc> device = scenario::load_device(file);
    if (!device) {
      complain(scenario::to_text(device.faults()));
      return std::nullopt;
    }
    if (Actuators::count(*device) == 0) continue;  // no motors, no wall
    axes.push_back(axis_of(name, *device));
  }
  return axes;
}

nlohmann::ordered_json to_json(const std::vector<analysis::stability::ZWidth>& widths) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const analysis::stability::ZWidth& width : widths) {
    const auto best = [](double K, double B) { return nlohmann::ordered_json{{"K", K}, {"B", B}}; };
    all.push_back({{"device", width.device},
                   {"delay_ticks", width.delay_ticks},
                   {"simulated", best(width.simulated.K_simulated, width.simulated.B)},
                   {"exact", best(width.exact.K_exact, width.exact.B)},
                   {"passive", best(width.passive.K_passive, width.passive.B)}});
  }
  return all;
}

// Of `run` count out, force and json.
struct StabilityOptions {
  RunOptions run;
  std::string device;  // empty: every one
};

int stability_command(const StabilityOptions& asked) {
  const RunOptions& options = asked.run;
  constexpr std::string_view files[] = {analysis::stability::kStabilityCsvName,
                                        analysis::stability::kStabilityPageName};
  const std::optional<std::vector<analysis::stability::NamedAxis>> models = device_axes(asked.device);
  if (!models) return kError;
  const auto place = report_place("stability", options, files);
  if (!place) return kError;
  ProgressBar bar;
  const analysis::stability::StabilityStudy study = analysis::stability::study_stability(
      *models, [&bar](std::string_view what, double fraction) { bar.show(what, fraction); });
  bar.clear();
  const auto folder = write_report(
      *place, {{analysis::stability::kStabilityCsvName, analysis::stability::stability_csv(study).text()},
               {analysis::stability::kStabilityPageName, analysis::stability::stability_page(study).html()}});
  if (!folder) return kError;
  if (options.json) {
    std::printf("%s\n",
                nlohmann::ordered_json{{"folder", folder->string()},
                                       {"tick_s", analysis::stability::kStudyTick},
                                       {"speed_m_per_s", analysis::stability::kStudySpeed},
                                       {"z_width", to_json(analysis::stability::z_widths(study.borders))}}
                    .dump(2)
                    .c_str());
    return kCompleted;
  }
  std::printf("%s\n", bold("The stiffest walls, at a tick of 1 ms").c_str());
  print_table(analysis::stability::z_width_table(study));
  std::printf("Plots and every border lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace

void add_stability(Program& program) {
  const auto options = std::make_shared<StabilityOptions>();
  program.add(
      kStabilityStudy.name, kStabilityStudy.about,
      [options](Arguments& arguments) {
        arguments.text(
            {"--device", "NAME", "A file of content/devices, by name (default: every one with motors)"},
            options->device);
        arguments.out(options->run);
        arguments.json("Print the figures as JSON", options->run.json);
      },
      [options] { return stability_command(*options); });
}

}  // namespace fulcrum::app
