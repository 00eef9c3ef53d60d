#include "engine/headset/worn.h"

#include "engine/xr/pose.h"

namespace fulcrum::headset {

Worn::Worn(HeadsetStage& stage, xr::Space space, Asked asked)
    : stage_(stage),
      session_(stage.runtime(), stage.gpu(), space),
      hands_(session_, asked.tips),
      tracking_(asked.hands ? std::make_unique<xr::HandTracking>(session_) : nullptr) {}

std::optional<xr::Frame> Worn::begin_frame() {
  return session_.begin_frame();
}

std::optional<std::array<xr::EyeView, 2>> Worn::eyes(const xr::Frame& frame) {
  if (!frame.should_render) return std::nullopt;
  return session_.eyes(frame);
}

std::array<xr::Hand, xr::kHands> Worn::hands(const xr::Frame& frame) {
  std::array<xr::Hand, xr::kHands> hands = hands_.read(frame);
  if (tracking_) {
    const auto joints = tracking_->read(frame);
    for (std::size_t i = 0; i < hands.size(); ++i) {
      const bool stops = hands[i].stops;
      hands[i] = pinches_[i].follow(joints[i]);
      hands[i].stops = hands[i].stops || stops;
    }
  }
  for (std::size_t i = 0; i < hands.size(); ++i)
    hands[i].X_LG = sightings_[i].follow(hands[i].X_LG, frame.display_time);
  return hands;
}

std::optional<Error> Worn::fit() {
  if (fitted_ == session_.times_begun()) return std::nullopt;
  const VkExtent2D eye = stage_.runtime().recommended_eye();
  const render::Extent both{2 * eye.width, eye.height};
  if (!(stage_.renderer().plan().picture == both))
    if (auto error = stage_.renderer().resize(both)) return error;
  pictures_.reset();
  pictures_ = std::make_unique<xr::Swapchain>(session_, VkExtent2D{both.width, both.height});
  fitted_ = session_.times_begun();
  return std::nullopt;
}

std::optional<Error> Worn::say(Panel& panel, const ui::OverlayState& state) {
  if (!sheet_) sheet_ = std::make_unique<xr::Swapchain>(session_, Panel::kSize);
  const VkImage target = sheet_->acquire();
  if (target == VK_NULL_HANDLE) return std::nullopt;
  if (auto error = panel.draw(state, target)) return error;
  sheet_->release();
  return std::nullopt;
}

Result<bool> Worn::show(const xr::Frame& frame, const std::array<xr::EyeView, 2>& eyes,
                        const render::FrameState& state, const PanelPlace& panel,
                        const render::LatePoses& late) {
  if (auto error = fit()) return *error;
  const VkImage target = pictures_->acquire();
  if (target == VK_NULL_HANDLE) return false;
  const auto copy = [&](VkCommandBuffer commands, const vulkan::Image& picture) {
    xr::copy_to(commands, picture.get(), target, picture.extent());
  };
  if (auto error = stage_.renderer().frame(state, copy, late)) return *error;
  pictures_->release();
  const VkExtent2D eye{pictures_->extent().width / 2, pictures_->extent().height};
  std::array<XrCompositionLayerProjectionView, 2> views;
  for (std::size_t i = 0; i < views.size(); ++i) {
    views[i] = xr::structure<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
    views[i].pose = xr::to_xr(eyes[i].X_LE);
    views[i].fov = eyes[i].fov;
    views[i].subImage = pictures_->part(static_cast<std::int32_t>(i * eye.width), 0, eye);
  }
  auto scene = xr::structure<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
  scene.space = session_.space();
  scene.viewCount = static_cast<std::uint32_t>(views.size());
  scene.views = views.data();
  std::vector layers{reinterpret_cast<const XrCompositionLayerBaseHeader*>(&scene)};
  auto sheet = xr::structure<XrCompositionLayerQuad>(XR_TYPE_COMPOSITION_LAYER_QUAD);
  if (sheet_ && sheet_->was_released()) {
    sheet.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
    sheet.space = session_.space();
    sheet.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
    sheet.subImage = sheet_->part(0, 0, Panel::kSize);
    sheet.pose = xr::to_xr(panel.X_LP);
    const auto width = static_cast<float>(panel.width);
    sheet.size = {width,
                  width * static_cast<float>(Panel::kSize.height) / static_cast<float>(Panel::kSize.width)};
    layers.push_back(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&sheet));
  }
  session_.end_frame(frame, layers);
  return true;
}

}  // namespace fulcrum::headset
