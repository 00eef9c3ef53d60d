#pragma once
// A picture of a scene, drawn without a window.

#include <filesystem>
#include <string>

#include "engine/app/cli/run_options.h"
#include "engine/app/picture/bridge.h"
#include "engine/render/plan.h"

namespace fulcrum::app {

// Drawn from the view that was asked for, with the circle where it was.
Result<scenario::VisualAssembly> assemble_shown(const Prepared& prepared, const SceneDesc& scene,
                                                const RunOptions& options);

struct FrameInput {
  TickRecord record;
  Afterglow afterglow;
  scenario::TaskState task;
  render::Camera camera;
  bool gpu_lost = false;  // nothing can be drawn any more
};

// Draws one frame into a PNG. `plan`, if given, receives what was built. Errors: no Vulkan, no such GPU, a
// file that cannot be written, what the validation layers say if options ask for them.
Result<std::filesystem::path> draw_picture(const Prepared& prepared, const SceneDesc& scene,
                                           const scenario::VisualAssembly& visual, const FrameInput& input,
                                           const RunOptions& options, const std::filesystem::path& file,
                                           render::RenderPlan* plan);

// The table of --gpu list, or why there is no Vulkan.
std::string describe_gpus();

}  // namespace fulcrum::app
