#pragma once
// The scene's pictures for both eyes, and how well they keep the headset's pace.

#include <array>
#include <filesystem>
#include <optional>

#include "engine/app/picture/bridge.h"
#include "engine/app/picture/late_tool.h"
#include "engine/app/run/run_session.h"
#include "engine/app/settings/settings.h"
#include "engine/app/window/frame_rate.h"
#include "engine/headset/placement.h"
#include "engine/headset/worn.h"
#include "engine/render/quality.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::headset {

class ScenePictures {
public:
  // All must outlive it.
  ScenePictures(HeadsetStage& stage, const app::Prepared& prepared, const scenario::VisualAssembly& visual,
                const app::Settings& settings, app::RunSession& attempt);

  // From here on they are seen from there. The left eye's.
  const render::Camera& look_from(const std::array<xr::EyeView, 2>& eyes, const Placement& placement);

  // Draws one, with the tool as late as may be where the trial runs, and shows it. False: the runtime took no
  // picture, and the frame has not ended.
  Result<bool> show(Worn& worn, const xr::Frame& frame, const std::array<xr::EyeView, 2>& eyes,
                    const PanelPlace& panel, const TickRecord& record, LiveLoop& loop);
  // Nothing can be shown from now on, until something is again.
  void rest() { frame_rate_.rest(); }
  // Where quality is automatic, chooses the next picture's. To be called once a mirror has shown this one:
  // the renderer has no picture of another quality until it draws one.
  std::optional<Error> keep_pace();

  // The last moment, as both eyes saw it, into a PNG.
  Result<std::filesystem::path> save(const std::filesystem::path& file);
  app::PictureFigures figures(std::optional<record::Colocated> colocation) const;

private:
  render::FrameState frame_of(const TickRecord& record);

  HeadsetStage& stage_;
  const app::Settings& settings_;
  app::RunSession& attempt_;
  render::Camera view_;  // of the scene, that the headset's space is laid about
  app::FrameBridge bridge_;
  app::FrameRate frame_rate_;
  XrDuration period_ = 0;  // ns, of the newest frame
  app::LateTool late_tool_;
  std::optional<render::AutoQuality> quality_;  // once the headset's pace is known, where it is automatic
  std::optional<std::array<render::Camera, 2>> eyes_;  // of the newest frame
};

}  // namespace fulcrum::headset
