// What a program shows in a frame, judged: poses that were handed out, pictures that were written.

#include <cmath>
#include <fstream>

#include "engine/xr/pose.h"
#include "tests/xr/runtime/headset.h"
#include "tests/xr/runtime/log.h"

namespace runtime {
namespace {

struct Pixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  bool operator==(const Pixels&) const = default;
};

// Null where it is none of the session's, or nothing of it was released.
const Swapchain* find(XrSwapchain handle) {
  for (const auto& swapchain : headset->session->swapchains)
    if (handle_of<XrSwapchain>(swapchain.get()) == handle && swapchain->released) return swapchain.get();
  return nullptr;
}

bool lies_in(const XrRect2Di& rect, const Swapchain& swapchain) {
  return rect.offset.x >= 0 && rect.offset.y >= 0 && rect.extent.width > 0 && rect.extent.height > 0 &&
         rect.offset.x + rect.extent.width <= static_cast<int>(swapchain.width) &&
         rect.offset.y + rect.extent.height <= static_cast<int>(swapchain.height);
}

Pixels part(const Swapchain& swapchain, const XrRect2Di& rect) {
  const std::vector<std::uint8_t> all = read(swapchain);
  Pixels pixels{
      static_cast<std::uint32_t>(rect.extent.width), static_cast<std::uint32_t>(rect.extent.height), {}};
  for (std::uint32_t y = 0; y < pixels.height; ++y)
    for (std::uint32_t x = 0; x < pixels.width; ++x) {
      const std::size_t column = static_cast<std::uint32_t>(rect.offset.x) + x;
      const std::size_t row = static_cast<std::uint32_t>(rect.offset.y) + y;
      const std::uint8_t* const pixel = &all[4 * (row * swapchain.width + column)];
      pixels.rgb.insert(pixels.rgb.end(), pixel, pixel + 3);
    }
  return pixels;
}

// Every pixel is, and not all alike.
bool is_written(const Pixels& pixels) {
  bool differs = false;
  for (std::size_t i = 0; i < pixels.rgb.size(); i += 3) {
    if (std::equal(kUnwritten.begin(), kUnwritten.end(), &pixels.rgb[i])) return false;
    differs = differs || !std::equal(&pixels.rgb[0], &pixels.rgb[3], &pixels.rgb[i]);
  }
  return differs;
}

void save_if_asked(const std::string& which, const Pixels& pixels) {
  for (const Event& event : headset->script.events) {
    const bool now = event.frame == 0 || event.frame == headset->frame;
    if (event.what != "picture" || !now || event.words.at(0) != which) continue;
    std::ofstream file(event.words.at(1), std::ios::binary);
    file << "P6\n" << pixels.width << ' ' << pixels.height << "\n255\n";
    file.write(reinterpret_cast<const char*>(pixels.rgb.data()),
               static_cast<std::streamsize>(pixels.rgb.size()));
  }
}

bool is_near(const XrPosef& a, const XrPosef& b) {
  const Pose A = fulcrum::xr::pose_of(a), B = fulcrum::xr::pose_of(b);
  return (A.p - B.p).norm() < 1e-5 && std::abs(A.q.dot(B.q)) > 1 - 1e-6;
}

bool is_near(const XrFovf& a, const XrFovf& b) {
  return a.angleLeft == b.angleLeft && a.angleRight == b.angleRight && a.angleUp == b.angleUp &&
         a.angleDown == b.angleDown;
}

void judge(const XrCompositionLayerProjection& layer) {
  if (layer.viewCount != 2) return wrong("a projection of " + std::to_string(layer.viewCount) + " views");
  const auto known = views_in(*reinterpret_cast<const Space*>(layer.space));
  std::array<Pixels, 2> eyes;
  for (std::size_t eye = 0; eye < eyes.size(); ++eye) {
    const XrCompositionLayerProjectionView& view = layer.views[eye];
    if (!is_near(view.pose, known[eye].pose)) wrong("an eye is not where it was told to be");
    if (!is_near(view.fov, known[eye].fov)) wrong("an eye sees another part than it was told to");
    const Swapchain* const swapchain = find(view.subImage.swapchain);
    if (swapchain == nullptr) return wrong("a picture that was not released is shown");
    if (swapchain->acquired) wrong("a picture is shown while another of its swapchain is drawn");
    if (!lies_in(view.subImage.imageRect, *swapchain)) return wrong("a part beyond a picture is shown");
    if (headset->frame % headset->script.look != 0) continue;
    eyes[eye] = part(*swapchain, view.subImage.imageRect);
    if (is_written(eyes[eye])) ++headset->written[eye];
    save_if_asked(eye == 0 ? "left" : "right", eyes[eye]);
  }
  ++headset->shown;
  headset->differing += eyes[0] == eyes[1] ? 0 : 1;
  const XrExtent2Di& size = layer.views[0].subImage.imageRect.extent;
  log("shown " + std::to_string(size.width) + "x" + std::to_string(size.height));
}

void judge(const XrCompositionLayerQuad& layer) {
  const Swapchain* const swapchain = find(layer.subImage.swapchain);
  if (swapchain == nullptr) return wrong("a panel that was not released is shown");
  if (!lies_in(layer.subImage.imageRect, *swapchain)) return wrong("a part beyond a panel is shown");
  if (!(layer.size.width > 0 && layer.size.height > 0)) wrong("a panel has no size");
  if (headset->frame % headset->script.look == 0)
    save_if_asked("quad", part(*swapchain, layer.subImage.imageRect));
  log("quad " + std::to_string(layer.size.width) + " " + std::to_string(layer.size.height) + " at " +
      std::to_string(layer.pose.position.x) + " " + std::to_string(layer.pose.position.y) + " " +
      std::to_string(layer.pose.position.z));
}

}  // namespace

XrResult judge_frame(const XrFrameEndInfo& info) {
  if (info.displayTime != headset->time) wrong("a frame is shown at another time than it was drawn for");
  if (info.environmentBlendMode != headset->script.blend) return XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED;
  for (std::uint32_t i = 0; i < info.layerCount; ++i)
    if (info.layers[i]->type == XR_TYPE_COMPOSITION_LAYER_PROJECTION)
      judge(*reinterpret_cast<const XrCompositionLayerProjection*>(info.layers[i]));
    else if (info.layers[i]->type == XR_TYPE_COMPOSITION_LAYER_QUAD)
      judge(*reinterpret_cast<const XrCompositionLayerQuad*>(info.layers[i]));
    else
      return XR_ERROR_LAYER_INVALID;
  return XR_SUCCESS;
}

}  // namespace runtime
