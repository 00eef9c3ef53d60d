#pragma once
// Choices that come round again.

#include <cstddef>

namespace fulcrum::app {

// On in a ring of `count`, by one or back by one.
inline std::size_t turned(std::size_t at, int by, std::size_t count) {
  const auto n = static_cast<std::ptrdiff_t>(count);
  return static_cast<std::size_t>((static_cast<std::ptrdiff_t>(at) + by + n) % n);
}

}  // namespace fulcrum::app
