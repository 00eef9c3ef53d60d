#include "engine/app/start/backdrop.h"

#include <numbers>
#include <utility>

#include "engine/render/orbit_camera.h"
#include "engine/scenario/content.h"
#include "engine/scenario/kept_levels.h"
#include "engine/scenario/load.h"
#include "haptics/math/functions.h"

namespace fulcrum::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kSettled = 150ms;     // who passes over a scenario does not wait for its models
constexpr double kSwing = 0.05;      // of the window's height, that a drag would be
constexpr double kSwingPeriod = 24;  // s

}  // namespace

Backdrop::~Backdrop() = default;  // a future of std::async waits

Backdrop::Read Backdrop::read(const Wanted& wanted) {
  Read read{.of = wanted, .scenario = {}, .visual = {}, .X_WT = {}};
  const Result<std::filesystem::path> file = scenario::find_scenario(wanted.name);
  if (!file) return read;
  std::vector<std::string> overrides;
  if (wanted.left_handed) overrides.emplace_back("left_handed=true");
  scenario::Checked<scenario::Scenario> loaded = scenario::load_scenario(*file, overrides);
  if (!loaded) return read;
  const scenario::Checked<scenario::LoadedModels> models = scenario::load_models(*loaded);
  if (!models) return read;
  scenario::Checked<scenario::VisualAssembly> visual =
      scenario::assemble_visual(*loaded, *models, SceneDesc());
  if (!visual) return read;
  visual->desc.markers.clear();
  // A cache that is damaged or cannot be written is told of when the scene is begun.
  scenario::add_levels_of_detail(visual->desc, BakeCache());
  read.X_WT = loaded->tool.X_WM_start * Pose{Quat::Identity(), models->p_MT};
  read.scenario = std::move(*loaded);
  read.visual = std::move(*visual);
  return read;
}

void Backdrop::want(const std::string& name, bool left_handed) {
  if (const Wanted wanted{name, left_handed}; wanted != wanted_) {
    wanted_ = wanted;
    since_ = Clock::now();
  }
  take();
  const bool busy = reading_.valid();
  if (busy || wanted_ == asked_ || wanted_.name.empty() || Clock::now() - since_ < kSettled) return;
  asked_ = wanted_;
  reading_ = std::async(std::launch::async, [wanted = wanted_] { return read(wanted); });
}

void Backdrop::take() {
  if (!reading_.valid() || reading_.wait_for(0s) != std::future_status::ready) return;
  auto ready = std::make_unique<Read>(reading_.get());
  if (ready->of != wanted_ || !ready->visual) return;
  if (stage_.set_scene(ready->visual->desc, {1, 1024, 1.0F})) return;
  SceneDesc scene;
  bridge_ = std::make_unique<FrameBridge>(ready->visual->desc, *ready->scenario, scene);
  shown_ = std::move(ready);
  begin_ = Clock::now();
}

render::FrameState Backdrop::frame() {
  if (!shown_) return {};
  const double time = std::chrono::duration<double>(Clock::now() - begin_).count();
  render::OrbitCamera camera(shown_->visual->desc.camera);
  camera.orbit(static_cast<float>(kSwing * math::sin(2 * std::numbers::pi * time / kSwingPeriod)), 0);
  TickRecord record;
  record.X_WT = record.X_WH = shown_->X_WT;
  return bridge_->frame(record, Afterglow(), {}, camera.camera(), time);
}

}  // namespace fulcrum::app
