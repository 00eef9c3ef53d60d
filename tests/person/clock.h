#pragma once

#include <chrono>

namespace fulcrum::person {

using Clock = std::chrono::steady_clock;

// s
inline double since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

}  // namespace fulcrum::person
