#include "engine/studies/picture_levels.h"

#include <cmath>
#include <cstdio>

#include "engine/analysis/picture/frame_times.h"
#include "engine/render/renderer.h"
#include "engine/studies/moving_shot.h"

namespace fulcrum::app {
namespace {

Result<DrawnLevel> draw_level(vulkan::Device& device, const render::VisualDesc& desc, const Shot& shot,
                              const render::RenderOptions& options) {
  const auto renderer = render::Renderer::create(device, desc, options);
  if (!renderer) return renderer.error();
  MovingShot frames(shot);
  analysis::picture::FrameTimes times(1);
  while (!times.are_enough()) {
    if (const auto error = (*renderer)->frame(frames.next())) return *error;
    times.add((*renderer)->last_frame_s());
  }
  if (const auto error = (*renderer)->frame(frames.still())) return *error;
  Result<render::Picture> picture = (*renderer)->read_back();
  if (!picture) return picture.error();
  return DrawnLevel{std::move(*picture), times.median_ms(0)};
}

}  // namespace

Result<std::vector<DrawnLevel>> draw_levels(vulkan::Device& device, render::VisualDesc desc, const Shot& shot,
                                            render::Extent extent) {
  without_marks(desc, shot);
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
  words += quality.shadow_size == 0 ? ", no shadows" : quality.soft_shadows ? ", soft shadows" : ", shadows";
  if (quality.shadow_size > 0) words += " of " + std::to_string(quality.shadow_size);
  if (quality.occlusion) words += ", ambient occlusion";
  if (quality.scattering > 0) words += ", light below surfaces of " + std::to_string(quality.scattering);
  if (quality.reflections) words += ", reflections";
  const auto percent = std::lround(100 * quality.resolution_scale);
  if (percent < 100) words += ", " + std::to_string(percent) + " % of the resolution";
  char coarse[48] = ", all triangles";
  if (quality.coarseness > 0.0F)
    std::snprintf(coarse, sizeof coarse, ", triangles to %g px", static_cast<double>(quality.coarseness));
  return words + coarse;
}

}  // namespace fulcrum::app
