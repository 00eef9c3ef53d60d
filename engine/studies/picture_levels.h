#pragma once
// A shot drawn at each quality level, and how long that takes.

#include <memory>
#include <string>
#include <vector>

#include "engine/render/picture.h"
#include "engine/render/plan.h"
#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/render/visual_desc.h"
#include "engine/studies/picture_shot.h"
#include "engine/vulkan/device.h"

namespace fulcrum::app {

struct TimedLevels {
  std::vector<std::unique_ptr<render::Renderer>> renderers;  // one for each of render::kQualityLevels
  std::vector<double> frame_ms;                              // of each of them, the median
};

// The levels take turns. desc: with the shot's instances.
Result<TimedLevels> time_levels(vulkan::Device& device, const render::VisualDesc& desc, const Shot& shot,
                                render::Extent extent);

struct DrawnLevel {
  render::Picture picture;
  double frame_ms = 0;  // the median
};

// One for each of render::kQualityLevels. desc: with the shot's instances; neither markers nor ghosts are
// drawn.
Result<std::vector<DrawnLevel>> draw_levels(vulkan::Device& device, render::VisualDesc desc, const Shot& shot,
                                            render::Extent extent);

// "1 sample, shadows of 1024, 75 % of the resolution, triangles to 0.5 px"
std::string words_of(const render::Quality& quality);

}  // namespace fulcrum::app
