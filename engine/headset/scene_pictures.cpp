#include "engine/headset/scene_pictures.h"

#include <chrono>
#include <utility>

#include "engine/render/picture.h"
#include "engine/ui/look.h"

namespace fulcrum::headset {
namespace {

constexpr double kPartOfFrame = 0.8;  // of the time between two pictures, that drawing may take

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ScenePictures::ScenePictures(HeadsetStage& stage, const app::Prepared& prepared,
                             const scenario::VisualAssembly& visual, const app::Settings& settings,
                             app::RunSession& attempt)
    : stage_(stage),
      settings_(settings),
      attempt_(attempt),
      view_(visual.desc.camera),
      bridge_(visual.desc, prepared.scenario, attempt.world().desc()) {}

const render::Camera& ScenePictures::look_from(const std::array<xr::EyeView, 2>& eyes,
                                               const Placement& placement) {
  eyes_ = {eye_camera(eyes.front(), placement, view_.layers),
           eye_camera(eyes.back(), placement, view_.layers)};
  return eyes_->front();
}

Result<bool> ScenePictures::show(Worn& worn, const xr::Frame& frame, const std::array<xr::EyeView, 2>& eyes,
                                 const PanelPlace& panel, const TickRecord& record, LiveLoop& loop) {
  const render::FrameState state =
      frame_of(record);  // which the loop may have, as long as it has no newer one
  const bool live = attempt_.sink().end() == app::RunSink::End::running &&
                    loop.newest_timed().sampled_ns > 0;  // the first tick has ended
  render::LatePoses late;
  if (live) late = late_tool_.poses(loop, bridge_, attempt_.sink().afterglow(), state.time_s);
  Result<bool> shown = worn.show(frame, eyes, state, panel, late);
  // The runtime may want pictures larger than there is graphics memory for at their level.
  if (!shown && quality_ && stage_.renderer().is_short_of_memory() && quality_->refuse() &&
      !render::take_quality(stage_.renderer(), *quality_))
    return false;
  if (!shown || !*shown) return shown;
  if (live) late_tool_.shown(stage_.renderer().last_submission_s());
  frame_rate_.note(now_s());
  period_ = frame.period;
  return shown;
}

std::optional<Error> ScenePictures::keep_pace() {
  if (!quality_ && !settings_.picture && period_ > 0)
    quality_.emplace(kPartOfFrame * 1e-9 * static_cast<double>(period_));
  if (!quality_ || !quality_->add(stage_.renderer().last_frame_s())) return std::nullopt;
  return render::take_quality(stage_.renderer(), *quality_);
}

Result<std::filesystem::path> ScenePictures::save(const std::filesystem::path& file) {
  if (auto error = stage_.renderer().frame(frame_of(attempt_.sink().last()))) return *error;
  const auto picture = stage_.renderer().read_back();
  if (!picture) return picture.error();
  if (auto error = render::write_png(file, *picture)) return *error;
  return file;
}

app::PictureFigures ScenePictures::figures(std::optional<record::Colocated> colocation) const {
  return {frame_rate_.mean(), late_tool_.figures(), std::move(colocation)};
}

render::FrameState ScenePictures::frame_of(const TickRecord& record) {
  const app::RunSink& sink = attempt_.sink();
  render::FrameState frame = bridge_.frame(record, sink.afterglow(), sink.task(), view_, sink.time());
  frame.eyes = eyes_;
  frame.marker_colours = ui::marker_colours(settings_.look);
  return frame;
}

}  // namespace fulcrum::headset
