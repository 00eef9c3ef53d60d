#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/analysis/stability/report.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/studies/commands.h"
#include "haptics/actuation/actuators.h"

namespace fulcrum::app {
namespace {

// Each device file of a device that has motors; what is wrong with another is said, and nothing is returned.
std::optional<std::vector<analysis::stability::NamedAxis>> device_axes() {
  std::vector<analysis::stability::NamedAxis> axes;
  for (const auto& [name, file] : scenario::device_files(scenario::content_roots())) {
    const scenario::Checked<DeviceDesc> device = scenario::load_device(file);
    if (!device) {
      complain(scenario::to_text(device.faults()));
      return std::nullopt;
    }
    if (Actuators::count(*device) == 0) continue;  // no motors, no wall
    axes.push_back({name,
                    {.mass = device->handle_mass,
                     .damping = device->damping,
                     .friction = device->friction,
                     .encoder_step = device->encoder_step}});
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

int stability_command(const RunOptions& options) {
  constexpr std::string_view files[] = {analysis::stability::kStabilityCsvName,
                                        analysis::stability::kStabilityPageName};
  const std::optional<std::vector<analysis::stability::NamedAxis>> models = device_axes();
  if (!models) return kError;
  const std::optional<std::filesystem::path> folder = report_folder("stability", options, files);
  if (!folder) return kError;
  ProgressBar bar;
  const analysis::stability::StabilityStudy study = analysis::stability::study_stability(
      *models, [&bar](std::string_view what, double fraction) { bar.show(what, fraction); });
  bar.clear();
  if (!write_report(
          *folder,
          {{analysis::stability::kStabilityCsvName, analysis::stability::stability_csv(study).text()},
           {analysis::stability::kStabilityPageName, analysis::stability::stability_page(study).html()}}))
    return kError;
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
  const auto options = std::make_shared<RunOptions>();
  program.add(
      kStabilityStudy.name, kStabilityStudy.about,
      [options](Arguments& arguments) {
        arguments.out(*options);
        arguments.json("Print the figures as JSON", options->json);
      },
      [options] { return stability_command(*options); });
}

}  // namespace fulcrum::app
