#include "haptics/loop/run_tick.h"

#include <algorithm>
#include <ctime>

namespace fulcrum {

std::int64_t thread_cpu_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

namespace {

DeviceCommand tick(World& world, const DeviceSample& sample, std::span<const Command> commands,
                   TickEvent& event) noexcept {
  event.sample = sample;
  const std::int64_t before = thread_cpu_ns();
  const StepResult result = step(world, sample, commands);
  event.cpu_ns = thread_cpu_ns() - before;
  event.record = result.record;
  event.command_count = static_cast<std::uint32_t>(std::min(commands.size(), kMaxCommandsPerTick));
  std::copy_n(commands.begin(), event.command_count, event.command.begin());
  return result.command;
}

}  // namespace

void run_tick(World& world, Device& device, std::span<const Command> commands, TickEvent& event) noexcept {
  device.write(tick(world, device.read(), commands, event));
}

void replay_tick(World& world, const DeviceSample& sample, std::span<const Command> commands,
                 TickEvent& event) noexcept {
  tick(world, sample, commands, event);
}

}  // namespace fulcrum
