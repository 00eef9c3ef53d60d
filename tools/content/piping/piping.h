#pragma once

#include <string>
#include <vector>

#include "tools/content/mesh/model.h"
#include "tools/content/piping/pipe_line.h"

namespace fulcrum::content {

// The lines of the plant, by number.
std::vector<PipeLine> pipe_lines();

// A corner of a plant: lines, a valve, a gauge and the frame that holds them.
Model make_piping();

// Part names that start like this belong to the two pipes of the slot.
bool is_slot_pipe(const std::string& part_name);

// The bolt, nut and washers that the spanner is led to.
bool is_target_bolt(const std::string& part_name);

}  // namespace fulcrum::content
