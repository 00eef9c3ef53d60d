#include "engine/studies/picture_study.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "engine/analysis/picture/report.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/files/put_file.h"
#include "engine/studies/picture_levels.h"
#include "engine/studies/picture_references.h"
#include "engine/studies/scene_description.h"
#include "engine/vulkan/instance.h"

namespace fulcrum::app {
namespace {

namespace measured = analysis::picture;

int refused(const Error& error) {
  complain(error.sentence);
  return kError;
}

// The scene that was asked for last stays prepared: shots of one follow each other.
class PreparedScenes {
public:
  const Prepared* get(const std::string& scene) {
    if (!prepared_ || name_ != scene) prepared_ = prepare(scene, std::vector<std::string>());
    name_ = scene;
    return prepared_ ? &*prepared_ : nullptr;
  }

private:
  std::string name_;
  std::optional<Prepared> prepared_;
};

Result<render::VisualDesc> visual_of(const Prepared& prepared, const Shot& shot) {
  if (const auto refused = refuse_view(prepared.scenario, prepared.name, shot.view))
    return Error{"A reference is of another view: " + refused->sentence};
  const Result<scenario::VisualAssembly> visual =
      assemble_view(prepared, scene_for_device(prepared, "simulated"), shot.view);
  if (!visual) return visual.error();
  std::size_t movable = 0;
  for (const render::Instance& instance : visual->desc.instances) movable += instance.movable ? 1 : 0;
  if (movable != shot.X_WM.size())
    return Error{"The references of '" + shot.scene +
                 "' are of a scene with other parts; make them anew with tools/references."};
  return visual->desc;
}

constexpr const char *kDescription = ".json", *kNumbers = ".bin";  // of a shot's files

// Why these shots may not be described in that folder; absent: nothing of theirs lies there, or it may go.
std::optional<Error> refuse_described(const std::vector<WantedShot>& wanted,
                                      const PictureStudyOptions& options) {
  if (options.run.force) return std::nullopt;
  for (const WantedShot& shot : wanted)
    for (const char* const end : {kDescription, kNumbers}) {
      const std::filesystem::path file = std::filesystem::path(options.describe) / (name_of(shot) + end);
      std::error_code none;
      if (std::filesystem::exists(std::filesystem::symlink_status(file, none)))
        return Error{file.string() +
                     " is there already: choose another folder with --describe, or replace it with --force."};
    }
  return std::nullopt;
}

int describe_all(const PictureStudyOptions& options) {
  std::vector<WantedShot> all = wanted_shots();
  if (!options.scene.empty())
    std::erase_if(all, [&](const WantedShot& shot) { return options.scene != shot.scene; });
  if (all.empty())
    return refused({"there is no scene '" + options.scene + "' to describe; fulcrum list has them."});
  if (const auto error = refuse_described(all, options)) return refused(*error);
  PreparedScenes scenes;
  for (const WantedShot& wanted : all) {
    const Prepared* prepared = scenes.get(wanted.scene);
    if (prepared == nullptr) return kError;
    const Result<Shot> shot = take_shot(*prepared, wanted);
    if (!shot) return refused(shot.error());
    const Result<render::VisualDesc> desc = visual_of(*prepared, *shot);
    if (!desc) return refused(desc.error());
    const SceneDescription description = describe(*desc, *shot);
    const std::string name = name_of(wanted);
    const std::filesystem::path base = std::filesystem::path(options.describe) / name;
    if (!put_file(base.string() + kDescription, {std::as_bytes(std::span(description.json))}) ||
        !put_file(base.string() + kNumbers, {std::as_bytes(std::span(description.bytes))}))
      return refused({base.string() + " cannot be written; is the folder writable, and is there room?"});
    std::printf("%s\n", name.c_str());
  }
  return kCompleted;
}

Result<measured::ViewFigures> measure(vulkan::Device& device, const Prepared& prepared,
                                      const Reference& reference) {
  const Result<render::Radiance> radiance = radiance_of(reference);
  if (!radiance) return radiance.error();
  const Result<render::VisualDesc> desc = visual_of(prepared, reference.shot);
  if (!desc) return desc.error();
  const auto levels = draw_levels(device, *desc, reference.shot, {radiance->width, radiance->height});
  if (!levels) return levels.error();
  measured::ViewFigures view{reference.shot.scene, reference.shot.view, reference.shot.time_s, {}, {}, false};
  view.stale = describe(*desc, reference.shot).digest != reference.digest;
  const measured::Image truth = shown_on(desc->background, *radiance);
  view.pictures.push_back({"Reference", render::png_bytes(picture_of(truth))});
  for (std::size_t level = 0; level < levels->size(); ++level) {
    const DrawnLevel& drawn = (*levels)[level];
    std::vector<double> map;
    measured::LevelFigures figures = measured::compared(truth, image_of(drawn.picture), map);
    figures.quality = words_of(render::kQualityLevels[level]);
    figures.frame_ms = drawn.frame_ms;
    view.levels.push_back(figures);
    // The best with its map, and the cheapest, to be looked at: all of them would be too much for a page.
    if (level == 0 || level + 1 == levels->size())
      view.pictures.push_back({"Level " + std::to_string(level), render::png_bytes(drawn.picture)});
    if (level == 0)
      view.pictures.push_back(
          {"Level 0, FLIP", render::png_bytes(picture_of(measured::coloured(map, truth.width)))});
  }
  return view;
}

nlohmann::ordered_json views_json(const std::vector<measured::ViewFigures>& views) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const measured::ViewFigures& view : views)
    for (std::size_t level = 0; level < view.levels.size(); ++level)
      all.push_back({{"scene", view.scene},
                     {"view", view.view},
                     {"level", level},
                     {"flip_mean", view.levels[level].flip_mean},
                     {"flip_p99", view.levels[level].flip_p99},
                     {"luminance_error", view.levels[level].luminance_error},
                     {"frame_ms", view.levels[level].frame_ms}});
  return all;
}

int measure_all(const PictureStudyOptions& options) {
  constexpr std::string_view files[] = {measured::kPictureCsvName, measured::kPicturePageName};
  const Result<std::vector<Reference>> references = find_references(options.scene);
  if (!references) return refused(references.error());
  const auto instance = vulkan::Instance::create({});
  if (!instance) return refused(instance.error());
  const auto device = vulkan::Device::create(*instance, options.run.gpu);
  if (!device) return refused(device.error());
  const auto place = report_place("workprecision", options.run, files);
  if (!place) return kError;
  PreparedScenes scenes;
  std::vector<measured::ViewFigures> views;
  ProgressBar bar;
  for (const Reference& reference : *references) {
    bar.show("Drawing", static_cast<double>(views.size()) / static_cast<double>(references->size()));
    const Prepared* prepared = scenes.get(reference.shot.scene);
    if (prepared == nullptr) return kError;
    Result<measured::ViewFigures> view = measure(**device, *prepared, reference);
    if (!view) return refused(view.error());
    views.push_back(std::move(*view));
  }
  bar.clear();
  for (const measured::ViewFigures& view : views)
    if (view.stale)
      complain("the reference of " + view.scene + ", " + view.view +
               " was drawn of another state of the scene: make it anew with tools/references.");
  const auto folder = write_report(
      *place, {{measured::kPictureCsvName, measured::picture_csv(views).text()},
               {measured::kPicturePageName, measured::picture_page(views, options.command).html()}});
  if (!folder) return kError;
  if (options.run.json) {
    std::printf(
        "%s\n",
        nlohmann::ordered_json{{"folder", folder->string()}, {"points", views_json(views)}}.dump(2).c_str());
    return kCompleted;
  }
  print_table(measured::level_table(views));
  std::printf("\n");
  print_table(measured::view_table(views));
  std::printf("Pictures beside their references lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace

int picture_study(const PictureStudyOptions& options) {
  return options.describe.empty() ? measure_all(options) : describe_all(options);
}

}  // namespace fulcrum::app
