#pragma once
// What the operating system is asked for, so that ticks come when they are due. A refusal is a sentence with
// what would grant it; empty when granted.

#include <string>

namespace fulcrum {

// SCHED_FIFO. Who reads a device's bus comes after the haptic thread and before all else: its samples would
// age while other programs run.
inline constexpr int kHapticPriority = 80, kReaderPriority = 70;

// For the calling thread.
std::string ask_for_scheduling(int priority);
// For the process.
std::string ask_for_locked_memory();

}  // namespace fulcrum
