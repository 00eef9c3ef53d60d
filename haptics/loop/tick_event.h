#pragma once
// One tick as a loop hands it on: what went in, what came out, what it cost.

#include <array>
#include <cstdint>
#include <span>

#include "haptics/device/device.h"
#include "haptics/tick/command.h"
#include "haptics/world/tick_record.h"

namespace fulcrum {

inline constexpr std::size_t kMaxCommandsPerTick = 8;

struct TickEvent {
  TickRecord record;
  DeviceSample sample;
  std::array<Command, kMaxCommandsPerTick> command{};
  std::uint32_t command_count = 0;
  std::int64_t lost_before = 0;   // ticks lost to an overrun before this one
  std::int64_t cpu_ns = 0;        // processor time of step()
  std::int64_t wake_late_ns = 0;  // how long after its deadline the tick began; 0 offline

  std::span<const Command> commands() const { return {command.data(), command_count}; }
};

}  // namespace fulcrum
