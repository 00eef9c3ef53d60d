#pragma once

namespace fulcrum::test {

inline constexpr double kTick = 1e-3;  // s

}  // namespace fulcrum::test
