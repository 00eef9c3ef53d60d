#include "engine/app/picture/picture.h"

#include <memory>

#include "engine/app/picture/impact_circle.h"
#include "engine/app/picture/target_view.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/render/renderer.h"
#include "engine/ui/overlay.h"
#include "engine/vulkan/device.h"
#include "engine/vulkan/instance.h"

namespace fulcrum::app {

Result<scenario::VisualAssembly> assemble_shown(const Prepared& prepared, const SceneDesc& scene,
                                                const RunOptions& options) {
  Result<scenario::VisualAssembly> visual = assemble_view(prepared, scene, options.view);
  if (!visual) return visual;
  if (options.overlay == kNoOverlay) {
    visual->desc.markers.clear();
    visual->desc.ghosts.clear();
  }
  if (options.circle) add_impact_circle(visual->desc);
  set_eyes(options.stereo, visual->desc.camera);
  for (scenario::View& view : visual->views) set_eyes(options.stereo, view.camera);
  return visual;
}

Result<std::filesystem::path> draw_picture(const Prepared& prepared, const SceneDesc& scene,
                                           const scenario::VisualAssembly& visual, const FrameInput& input,
                                           const RunOptions& options, const std::filesystem::path& file,
                                           render::RenderPlan* plan) {
  vulkan::InstanceOptions instance_options;
  instance_options.validation = options.validate;
  const auto instance = vulkan::Instance::create(instance_options);
  if (!instance) return instance.error();
  const auto device = vulkan::Device::create(*instance, options.gpu);
  if (!device) return device.error();
  render::RenderOptions wanted;
  wanted.extent = options.size;
  wanted.stereo = stereo_of(options.stereo);
  wanted.at_screen = options.overlay != kNoOverlay;
  const auto renderer = render::Renderer::create(**device, visual.desc, wanted);
  if (!renderer) return renderer.error();
  if (plan != nullptr) *plan = (*renderer)->plan();

  ui::OverlayState shown = overlay_state(prepared, scene, input.record, input.afterglow, input.task);
  FrameBridge bridge(visual.desc, prepared.scenario, scene);
  render::FrameState frame =
      bridge.frame(input.record, input.afterglow, input.task, input.camera, shown.time_s);
  std::unique_ptr<ui::Overlay> overlay;
  if (options.overlay != kNoOverlay) {
    auto made = ui::Overlay::create(**device);
    if (!made) return made.error();
    overlay = std::move(*made);
    shown.target = target_view(seen_by_middle(wanted.stereo, input.camera), options.size, input.record,
                               prepared.haptic.task, input.task);
    if (auto error = overlay->prepare(shown, options.size)) return *error;
    frame.overlay = overlay.get();
  }
  if (input.gpu_lost) (*device)->lose();
  if (auto error = (*renderer)->frame(frame)) return *error;
  const auto picture = (*renderer)->read_back();
  if (!picture) return picture.error();
  if (auto error = render::write_png(file, *picture)) return *error;
  if (const auto said = instance->messages(); !said.empty()) return Error{said.front()};
  return file;
}

std::string describe_gpus() {
  const auto instance = vulkan::Instance::create({});
  return instance ? vulkan::describe(vulkan::list_devices(*instance)) : instance.error().sentence;
}

}  // namespace fulcrum::app
