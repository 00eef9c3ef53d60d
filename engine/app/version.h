#pragma once

namespace fulcrum::app {

inline constexpr const char* kVersion = FULCRUM_VERSION;  // from CMakeLists.txt

// What computes the ticks: a tape is replayed by the same target or refused. Doubles in the order they are
// written, as every x86-64 has them.
inline constexpr const char* kSimdTarget = "x86-64 baseline";

}  // namespace fulcrum::app
