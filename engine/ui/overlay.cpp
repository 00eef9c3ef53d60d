#include "engine/ui/overlay.h"

#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/ui/cue_panel.h"
#include "engine/ui/fonts.h"
#include "engine/ui/panels.h"
#include "engine/ui/peak_hold.h"
#include "engine/vulkan/commands.h"
#include "engine/vulkan/handle.h"

namespace fulcrum::ui {
namespace {

// ImGui 1.86 knows render passes only. This one draws over what dynamic rendering has left in the picture.
vulkan::RenderPassHandle make_render_pass(VkDevice device) {
  VkAttachmentDescription picture{};
  picture.format = render::kPictureFormat;
  picture.samples = VK_SAMPLE_COUNT_1_BIT;
  picture.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  picture.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  picture.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  picture.initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  picture.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  VkSubpassDependency after_scene{};
  after_scene.srcSubpass = VK_SUBPASS_EXTERNAL;
  after_scene.srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  after_scene.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  after_scene.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  after_scene.dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  VkRenderPassCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
  info.attachmentCount = 1;
  info.pAttachments = &picture;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = 1;
  info.pDependencies = &after_scene;
  VkRenderPass pass = VK_NULL_HANDLE;
  vulkan::check(vkCreateRenderPass(device, &info, nullptr, &pass), "prepare to draw text");
  return {device, pass};
}

vulkan::DescriptorPoolHandle make_pool(VkDevice device) {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
  VkDescriptorPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  info.maxSets = 1;
  info.poolSizeCount = 1;
  info.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  vulkan::check(vkCreateDescriptorPool(device, &info, nullptr, &pool), "prepare to draw text");
  return {device, pool};
}

}  // namespace

class Overlay::Implementation {
public:
  explicit Implementation(vulkan::Device& device)
      : device_(device), pass_(make_render_pass(device.get())), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGui::GetIO().IniFilename = nullptr;  // nothing here is worth a file
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
  }

  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  ~Implementation() {
    vkDeviceWaitIdle(device_.get());
    ImGui::SetCurrentContext(context_);
    shut_backend();
    ImGui::DestroyContext(context_);
  }

  void prepare(const OverlayState& state, render::Extent picture) {
    ImGui::SetCurrentContext(context_);
    const float scale = overlay_scale(picture.height, state.look.text);
    if (scale != scale_) start_backend(scale);
    const ImVec2 size{static_cast<float>(picture.width), static_cast<float>(picture.height)};
    ImGui::GetIO().DisplaySize = size;
    ImGui::GetIO().DeltaTime = 1.0F / 60.0F;  // nothing is animated by ImGui itself
    ImGui_ImplVulkan_NewFrame();
    ImGui::NewFrame();
    const Peaks peaks{force_peak_.add(state.force_N.value, state.time_s),
                      torque_peak_.add(state.torque_Nm.value, state.time_s)};
    const Canvas canvas(*ImGui::GetBackgroundDrawList(), fonts_, palette(state.look.palette), size, scale);
    draw_overlay(canvas, state, peaks);
    keys_pages_ = fulcrum::ui::keys_pages(canvas, state);
    place_second_view(canvas, state, picture);
    ImGui::Render();
  }

  void record(VkCommandBuffer commands, const render::OverlayTarget& target) {
    if (generation_ != target.generation) make_framebuffer(target);
    ImGui::SetCurrentContext(context_);
    ImDrawData* data = ImGui::GetDrawData();
    const bool fits = data != nullptr && data->DisplaySize.x == static_cast<float>(target.extent.width) &&
                      data->DisplaySize.y == static_cast<float>(target.extent.height);
    if (!fits) return;  // prepared for another size, or never: the next frame is right
    VkRenderPassBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    begin.renderPass = pass_.get();
    begin.framebuffer = framebuffer_.get();
    begin.renderArea = {{0, 0}, target.extent};
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    ImGui_ImplVulkan_RenderDrawData(data, commands);
    vkCmdEndRenderPass(commands);
  }

  const std::string& font_note() const { return font_note_; }
  std::size_t keys_pages() const { return keys_pages_; }
  const std::optional<PixelArea>& second_view() const { return second_view_; }

private:
  void place_second_view(const Canvas& canvas, const OverlayState& state, render::Extent picture) {
    second_view_.reset();
    const Area area = second_view_area(canvas, state);
    if (!(area.size.x > 0.0F)) return;
    const auto pixel = [this](float units, std::uint32_t most) {
      return static_cast<std::uint32_t>(std::clamp(std::lround(units * scale_), 0L, static_cast<long>(most)));
    };
    PixelArea placed{pixel(area.at.x, picture.width), pixel(area.at.y, picture.height)};
    placed.width = std::min(pixel(area.size.x, picture.width), picture.width - placed.x);
    placed.height = std::min(pixel(area.size.y, picture.height), picture.height - placed.y);
    if (placed.width > 0 && placed.height > 0) second_view_ = placed;
  }

  // The backend keeps the texture of one atlas for its lifetime: other fonts, another backend.
  void start_backend(float scale) {
    vulkan::check(vkDeviceWaitIdle(device_.get()), "draw text");
    shut_backend();
    fonts_ = load_fonts(scale, font_note_);
    pool_ = make_pool(device_.get());
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = device_.instance();
    info.PhysicalDevice = device_.physical();
    info.Device = device_.get();
    info.QueueFamily = device_.queue_family();
    info.Queue = device_.queue();
    info.DescriptorPool = pool_.get();
    info.MinImageCount = 2;  // the least it accepts
    info.ImageCount = 2;
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = [](VkResult code) { vulkan::check(code, "draw text"); };
    ImGui_ImplVulkan_Init(&info, pass_.get());
    running_ = true;
    vulkan::Commands(device_).run(
        [](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
    scale_ = scale;
  }

  void shut_backend() {
    if (running_) {
      ImGui_ImplVulkan_Shutdown();
      running_ = false;
    }
  }

  void make_framebuffer(const render::OverlayTarget& target) {
    VkFramebufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    info.renderPass = pass_.get();
    info.attachmentCount = 1;
    info.pAttachments = &target.view;
    info.width = target.extent.width;
    info.height = target.extent.height;
    info.layers = 1;
    VkFramebuffer made = VK_NULL_HANDLE;
    vulkan::check(vkCreateFramebuffer(device_.get(), &info, nullptr, &made), "draw text over the picture");
    framebuffer_ = vulkan::FramebufferHandle(device_.get(), made);
    generation_ = target.generation;
  }

  vulkan::Device& device_;
  vulkan::RenderPassHandle pass_;
  vulkan::DescriptorPoolHandle pool_;
  vulkan::FramebufferHandle framebuffer_;
  std::uint64_t generation_ = 0;
  ImGuiContext* context_;
  Fonts fonts_;
  std::string font_note_;
  float scale_ = 0.0F;
  std::size_t keys_pages_ = 0;
  bool running_ = false;
  PeakHold force_peak_;
  PeakHold torque_peak_;
  std::optional<PixelArea> second_view_;
};

vulkan::Result<std::unique_ptr<Overlay>> Overlay::create(vulkan::Device& device) {
  try {
    return std::unique_ptr<Overlay>(new Overlay(std::make_unique<Implementation>(device)));
  } catch (const vulkan::Failure& failure) {
    return vulkan::Error{failure.what()};
  }
}

Overlay::Overlay(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

Overlay::~Overlay() = default;

std::optional<vulkan::Error> Overlay::prepare(const OverlayState& state, render::Extent picture) {
  try {
    implementation_->prepare(state, picture);
    return {};
  } catch (const vulkan::Failure& failure) {
    return vulkan::Error{failure.what()};
  }
}

std::size_t Overlay::keys_pages() const {
  return implementation_->keys_pages();
}

const std::string& Overlay::font_note() const {
  return implementation_->font_note();
}

const std::optional<PixelArea>& Overlay::second_view() const {
  return implementation_->second_view();
}

void Overlay::record(VkCommandBuffer commands, const render::OverlayTarget& target) {
  implementation_->record(commands, target);
}

}  // namespace fulcrum::ui
