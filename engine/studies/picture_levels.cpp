#include "engine/studies/picture_levels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/renderer.h"

namespace fulcrum::app {
namespace {

constexpr int kUncounted = 3;  // frames: drivers compile shaders while drawing the first ones
constexpr std::size_t kFrames = 9;
constexpr float kStep = 1e-5F;  // m, that the tool moves between frames, so that its shadow is drawn anew

Result<DrawnLevel> draw_level(vulkan::Device& device, const render::VisualDesc& desc, const Shot& shot,
                              const render::RenderOptions& options) {
  const auto renderer = render::Renderer::create(device, desc, options);
  if (!renderer) return renderer.error();
  std::vector<glm::mat4> moved = shot.X_WM;
  for (glm::mat4& X : moved) X[3].y += kStep;
  render::FrameState state;
  state.camera = shot.camera;
  std::array<double, kFrames> times{};
  // The last frame shows the moment itself.
  for (int frame = 1 - kUncounted - static_cast<int>(kFrames); frame <= 0; ++frame) {
    state.X_WM = frame % 2 == 0 ? shot.X_WM : moved;
    if (const auto error = (*renderer)->frame(state)) return *error;
    if (frame > -static_cast<int>(kFrames))
      times[static_cast<std::size_t>(-frame)] = (*renderer)->last_frame_s();
  }
  Result<render::Picture> picture = (*renderer)->read_back();
  if (!picture) return picture.error();
  std::ranges::nth_element(times, times.begin() + kFrames / 2);
  return DrawnLevel{std::move(*picture), 1e3 * times[kFrames / 2]};
}

}  // namespace

Result<std::vector<DrawnLevel>> draw_levels(vulkan::Device& device, render::VisualDesc desc, const Shot& shot,
                                            render::Extent extent) {
  desc.markers.clear();
  desc.ghosts.clear();
  desc.camera = shot.camera;
  std::vector<DrawnLevel> levels;
  for (const render::Quality& quality : render::kQualityLevels) {
    render::RenderOptions options;
    options.extent = extent;
    options.quality = quality;
    Result<DrawnLevel> drawn = draw_level(device, desc, shot, options);
    if (!drawn) return drawn.error();
    levels.push_back(std::move(*drawn));
  }
  return levels;
}

std::string words_of(const render::Quality& quality) {
  std::string words = quality.samples == 1 ? "1 sample" : std::to_string(quality.samples) + " samples";
  words += quality.shadow_size > 0 ? ", shadows of " + std::to_string(quality.shadow_size) : ", no shadows";
  const auto percent = std::lround(100 * quality.resolution_scale);
  return words + (percent == 100 ? "" : ", " + std::to_string(percent) + " % of the resolution");
}

}  // namespace fulcrum::app
