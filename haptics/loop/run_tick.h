#pragma once
// Read, step, write: what one turn of every loop is.

#include <span>

#include "haptics/device/device.h"
#include "haptics/loop/tick_event.h"
#include "haptics/world/world.h"

namespace fulcrum {

// Processor time of this thread, ns.
std::int64_t thread_cpu_ns() noexcept;

// commands: at most kMaxCommandsPerTick. lost_before and wake_late_ns are the caller's to set.
void run_tick(World& world, Device& device, std::span<const Command> commands, TickEvent& event) noexcept;

// The same from a tape: the sample and the commands of then, and no device.
void replay_tick(World& world, const DeviceSample& sample, std::span<const Command> commands,
                 TickEvent& event) noexcept;

}  // namespace fulcrum
