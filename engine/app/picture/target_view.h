#pragma once
// The way to the next checkpoint as a camera sees it: what the overlay draws of it, without a renderer.

#include <optional>
#include <string>

#include "drivers/registry.h"
#include "engine/app/prepare/prepare.h"
#include "engine/render/plan.h"
#include "engine/scenario/task_judge.h"
#include "engine/ui/target_state.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

// None: there is no checkpoint left, or the tool is nowhere.
std::optional<ui::TargetPlace> target_place(const render::Camera& camera, render::Extent picture,
                                            const TickRecord& record, const scenario::TaskDesc& task,
                                            const scenario::TaskState& state);

// The way to the touch point where that is out of the picture; none: it is in it, or nowhere.
std::optional<ui::EdgePlace> lost_tool(const render::Camera& camera, render::Extent picture,
                                       const TickRecord& record, const scenario::TaskDesc& task);

// The next checkpoint with its names and how long the tool has been there.
std::optional<ui::Target> target_view(const render::Camera& camera, render::Extent picture,
                                      const TickRecord& record, const scenario::TaskDesc& task,
                                      const scenario::TaskState& state);

// The hint of the checkpoint that is next, as a device does what it speaks of; empty: it has none.
std::string advice(const scenario::TaskDesc& task, const scenario::TaskState& state,
                   const DeviceWords& words);

}  // namespace fulcrum::app
