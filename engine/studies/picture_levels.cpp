#include "engine/studies/picture_levels.h"

#include <cmath>
#include <cstdio>

#include "engine/analysis/picture/frame_times.h"
#include "engine/studies/moving_shot.h"

namespace fulcrum::app {

Result<TimedLevels> time_levels(vulkan::Device& device, const render::VisualDesc& desc, const Shot& shot,
                                render::Extent extent) {
  TimedLevels timed;
  for (const render::Quality& quality : render::kQualityLevels) {
    render::RenderOptions options;
    options.extent = extent;
    options.quality = quality;
    auto renderer = render::Renderer::create(device, desc, options);
    if (!renderer) return renderer.error();
    timed.renderers.push_back(std::move(*renderer));
  }
  MovingShot frames(shot);
  render::FrameState state;
  const auto times = analysis::picture::FrameTimes::by_turns(
      timed.renderers.size(), [&](std::size_t level) -> Result<double> {
        if (level == 0) state = frames.next();
        if (const auto error = timed.renderers[level]->frame(state)) return *error;
        return timed.renderers[level]->last_frame_s();
      });
  if (!times) return times.error();
  for (std::size_t level = 0; level < timed.renderers.size(); ++level)
    timed.frame_ms.push_back(times->median_ms(level));
  return timed;
}

Result<std::vector<DrawnLevel>> draw_levels(vulkan::Device& device, render::VisualDesc desc, const Shot& shot,
                                            render::Extent extent) {
  without_marks(desc, shot);
  const Result<TimedLevels> timed = time_levels(device, desc, shot, extent);
  if (!timed) return timed.error();
  const MovingShot frames(shot);
  std::vector<DrawnLevel> levels;
  for (std::size_t level = 0; level < timed->renderers.size(); ++level) {
    render::Renderer& renderer = *timed->renderers[level];
    if (const auto error = renderer.frame(frames.still())) return *error;
    Result<render::Picture> picture = renderer.read_back();
    if (!picture) return picture.error();
    levels.push_back({std::move(*picture), timed->frame_ms[level]});
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
