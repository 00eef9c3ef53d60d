#include "engine/app/edit/reloader.h"

#include <chrono>
#include <utility>

#include "engine/files/regular_file.h"
#include "engine/scenario/load.h"
#include "engine/scenario/text_store.h"
#include "haptics/bake/overlap_depth.h"

namespace fulcrum::app {
namespace {

// Ends a bake from within its progress.
struct Ended {};

// m. A response pushes a tool out that is less deep.
constexpr double kPushedOut = 2e-4;

// What it names, there or not.
std::vector<std::filesystem::path> files_of(const scenario::Scenario& scenario) {
  std::vector<std::filesystem::path> files;
  for (const scenario::ModelEntry& model : scenario.models)
    for (const scenario::FileRef& file : {model.file, model.drawn})
      if (!file.path.empty()) files.push_back(file.path);
  for (const scenario::HandEntry& hand : scenario.hands)
    if (!hand.path.path.empty()) files.push_back(hand.path.path);
  if (scenario.surroundings && !scenario.surroundings->file.path.empty())
    files.push_back(scenario.surroundings->file.path);
  return files;
}

// What the models' files name themselves: buffers, textures.
void add_beside(const Prepared& prepared, std::vector<std::filesystem::path>& files) {
  const auto add = [&](const Model& model, const scenario::FileRef& file) {
    for (const std::string& name : model.beside) files.push_back(file.path.parent_path() / name);
  };
  for (std::size_t i = 0; i < prepared.scenario.models.size(); ++i) {
    const scenario::ModelEntry& entry = prepared.scenario.models[i];
    add(prepared.models.models[i], entry.file);
    if (const auto& drawn = prepared.models.drawn[i]) add(*drawn, entry.drawn);
  }
}

}  // namespace

Reloader::Reloader(std::filesystem::path file, const scenario::Scenario& shown,
                   std::filesystem::path calibration)
    : file_(std::move(file)),
      overrides_(shown.overrides),
      calibration_(std::move(calibration)),
      watch_(file_.parent_path().empty() ? "." : file_.parent_path()) {
  watch_.also({file_});
  watch_.also(files_of(shown));
  const Result<std::string> text = scenario::read_text(RegularFile::open(file_));
  saved_again_ = !text || *text != shown.texts.files.at(shown.texts.scenario);
}

void Reloader::watch_beside(const Prepared& shown) {
  std::vector<std::filesystem::path> files;
  add_beside(shown, files);
  watch_.also(files);
}

Reloader::~Reloader() {
  ends_ = true;
}

Reloader::Made Reloader::make() const {
  scenario::Checked<scenario::Scenario> loaded = scenario::load_scenario(file_, overrides_, calibration_);
  if (!loaded)
    return {nullptr, scenario::to_text(loaded.faults()),
            files_of(scenario::inspect_scenario(file_, overrides_).scenario)};
  std::vector<std::filesystem::path> files = files_of(*loaded);
  try {
    Result<Prepared> prepared = prepare_quietly(
        file_.string(), std::move(*loaded), [](const std::string&) {},
        [this](std::string_view, double) {
          if (ends_) throw Ended();
        });
    if (!prepared) return {nullptr, prepared.error().sentence, std::move(files)};
    add_beside(*prepared, files);
    // What would end the session once it has taken over.
    const auto seen = assemble_visual(prepared->scenario, prepared->models, prepared->haptic.scene);
    if (!seen) return {nullptr, scenario::to_text(seen.faults()), std::move(files)};
    const Result<World> ticks = World::build(prepared->haptic.scene);
    if (!ticks) return {nullptr, ticks.error().sentence, std::move(files)};
    return {std::make_unique<Prepared>(std::move(*prepared)), {}, std::move(files)};
  } catch (const Ended&) {
    return {};
  }
}

void Reloader::look() {
  using namespace std::chrono_literals;
  if (watch_.saved()) saved_again_ = true;
  if (making_.valid() && making_.wait_for(0s) == std::future_status::ready) {
    Made made = making_.get();
    watch_.also(made.files);
    if (!saved_again_) {  // or there is a newer one
      wrong_ = std::move(made.said);
      if (made.prepared) ready_ = std::move(made.prepared);
    }
  }
  if (saved_again_ && !making_.valid()) {
    saved_again_ = false;
    ready_.reset();
    making_ = std::async(std::launch::async, [this] { return make(); });
  }
}

std::string Reloader::message() const {
  if (making_.valid()) return "Reading what was saved.";
  return wrong_;
}

bool begin_at(Prepared& prepared, const Pose& X_WM) {
  const Pose X_WT = X_WM * Pose{Quat::Identity(), prepared.models.p_MT};
  const OverlapDepth overlap(prepared.haptic.scene_W, prepared.haptic.tool_T,
                             prepared.haptic.scene.scene_field.get());
  if (overlap.at(X_WT, {.above = kPushedOut, .tolerance = kPushedOut, .distances = 20'000}).depth >
      kPushedOut)
    return false;
  prepared.scenario.tool.X_WM_start = X_WM;
  prepared.haptic.scene.tool.X_WT_start = X_WT;
  return true;
}

}  // namespace fulcrum::app
