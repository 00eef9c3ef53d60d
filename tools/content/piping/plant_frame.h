#pragma once

#include <span>

#include "tools/content/piping/pipe_line.h"
#include "tools/content/piping/plant.h"

namespace fulcrum::content {

// Posts, cross bars and arms of channel steel, and the clamps that hold the lines on them.
void add_plant_frame(Plant* plant, std::span<const PipeLine> lines);

}  // namespace fulcrum::content
