#include "engine/studies/speed_study.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "engine/analysis/picture/speed_report.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/studies/moving_shot.h"
#include "engine/studies/picture_levels.h"
#include "engine/vulkan/instance.h"

namespace fulcrum::app {
namespace {

using analysis::picture::SpeedFigures;

constexpr std::array<render::Extent, 3> kSizes = {{{640, 360}, {1280, 720}, {1920, 1080}}};

Result<SpeedFigures> measure_speed(vulkan::Device& device, const render::VisualDesc& desc, const Shot& shot,
                                   render::Extent extent) {
  const Result<TimedLevels> timed = time_levels(device, desc, shot, extent);
  if (!timed) return timed.error();
  SpeedFigures figures{shot.scene, shot.view, extent.width, extent.height, {}, timed->frame_ms, {}};
  for (const render::Quality& quality : render::kQualityLevels)
    figures.qualities.push_back(words_of(quality));
  for (const auto& renderer : timed->renderers) figures.triangles.push_back(renderer->triangles());
  return figures;
}

// Of a scene as it begins, at every size.
Result<std::vector<SpeedFigures>> measure_scene(vulkan::Device& device, const WantedShot& wanted) {
  const std::optional<Prepared> prepared = prepare(wanted.scene, std::vector<std::string>());
  if (!prepared) return Error{"The scene '" + std::string(wanted.scene) + "' cannot be drawn."};
  const Result<Shot> shot = take_shot(*prepared, wanted);
  if (!shot) return shot.error();
  Result<scenario::VisualAssembly> visual =
      assemble_view(*prepared, scene_for_device(*prepared, "simulated"), wanted.view);
  if (!visual) return visual.error();
  without_marks(visual->desc, *shot);
  std::vector<SpeedFigures> all;
  for (const render::Extent extent : kSizes) {
    Result<SpeedFigures> figures = measure_speed(device, visual->desc, *shot, extent);
    if (!figures) return figures.error();
    all.push_back(std::move(*figures));
  }
  return all;
}

nlohmann::ordered_json speed_json(const std::vector<SpeedFigures>& all) {
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const SpeedFigures& figures : all)
    for (std::size_t level = 0; level < figures.frame_ms.size(); ++level)
      points.push_back({{"scene", figures.scene},
                        {"view", figures.view},
                        {"width", figures.width},
                        {"height", figures.height},
                        {"level", level},
                        {"triangles", figures.triangles[level]},
                        {"frame_ms", figures.frame_ms[level]}});
  return points;
}

int refused(const std::string& sentence) {
  complain(sentence);
  return kError;
}

}  // namespace

int speed_study(const PictureStudyOptions& options) {
  namespace measured = analysis::picture;
  constexpr std::string_view files[] = {measured::kSpeedCsvName, measured::kSpeedPageName};
  std::vector<WantedShot> wanted = wanted_shots();
  std::erase_if(wanted, [&](const WantedShot& shot) {
    return shot.time_s > 0 || (!options.scene.empty() && options.scene != shot.scene);
  });
  if (wanted.empty())
    return refused("there is no scene '" + options.scene + "' to draw; fulcrum list has them.");
  const auto instance = vulkan::Instance::create({});
  if (!instance) return refused(instance.error().sentence);
  const auto device = vulkan::Device::create(*instance, options.run.gpu);
  if (!device) return refused(device.error().sentence);
  const auto place = report_place("workprecision", options.run, files);
  if (!place) return kError;
  std::vector<SpeedFigures> all;
  ProgressBar bar;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    bar.show("Drawing", static_cast<double>(i) / static_cast<double>(wanted.size()));
    Result<std::vector<SpeedFigures>> figures = measure_scene(**device, wanted[i]);
    if (!figures) return refused(figures.error().sentence);
    all.insert(all.end(), figures->begin(), figures->end());
  }
  bar.clear();
  const auto folder =
      write_report(*place, {{measured::kSpeedCsvName, measured::speed_csv(all).text()},
                            {measured::kSpeedPageName, measured::speed_page(all, options.command).html()}});
  if (!folder) return kError;
  if (options.run.json) {
    std::printf(
        "%s\n",
        nlohmann::ordered_json{{"folder", folder->string()}, {"points", speed_json(all)}}.dump(2).c_str());
    return kCompleted;
  }
  std::printf("Frames a second:\n");
  print_table(measured::speed_table(all));
  std::printf("The levels, and triangles in view, lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace fulcrum::app
