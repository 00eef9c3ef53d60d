#include "engine/app/picture/picture.h"

#include <memory>

#include "engine/render/renderer.h"
#include "engine/ui/overlay.h"
#include "engine/vulkan/device.h"
#include "engine/vulkan/instance.h"

namespace fulcrum::app {

Result<std::filesystem::path> draw_picture(const Prepared& prepared, const SceneDesc& scene,
                                           const scenario::VisualAssembly& visual, const Moment& moment,
                                           const RunOptions& options, const std::filesystem::path& file,
                                           render::RenderPlan* plan) {
  vulkan::InstanceOptions instance_options;
  instance_options.validation = options.validate;
  const auto instance = vulkan::Instance::create(instance_options);
  if (!instance) return Error{instance.error()};
  const auto device = vulkan::Device::create(instance.value(), options.gpu);
  if (!device) return Error{device.error()};
  const auto overlay = ui::Overlay::create(*device.value());
  if (!overlay) return Error{overlay.error()};
  render::RenderOptions wanted;
  wanted.extent = options.size;
  const auto renderer = render::Renderer::create(*device.value(), visual.desc, wanted);
  if (!renderer) return Error{renderer.error()};
  if (plan != nullptr) *plan = renderer.value()->plan();

  const ui::OverlayState shown = overlay_state(prepared, scene, moment.record, moment.afterglow, moment.task);
  if (const auto laid_out = overlay.value()->prepare(shown, options.size); !laid_out)
    return Error{laid_out.error()};
  FrameBridge bridge(visual.desc, prepared.scenario, scene);
  render::FrameState frame =
      bridge.frame(moment.record, moment.afterglow, moment.task, moment.camera, shown.time_s);
  frame.overlay = overlay.value().get();
  if (const auto drawn = renderer.value()->frame(frame); !drawn) return Error{drawn.error()};
  const auto picture = renderer.value()->read_back();
  if (!picture) return Error{picture.error()};
  if (const auto written = render::write_png(file, picture.value()); !written) return Error{written.error()};
  if (const auto said = instance.value().messages(); !said.empty()) return Error{said.front()};
  return file;
}

std::string describe_gpus() {
  const auto instance = vulkan::Instance::create({});
  return instance ? vulkan::describe(vulkan::list_devices(instance.value())) : instance.error();
}

}  // namespace fulcrum::app
