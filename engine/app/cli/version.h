#pragma once

namespace fulcrum::app {

inline constexpr const char* kVersion = FULCRUM_VERSION;  // from CMakeLists.txt

}  // namespace fulcrum::app
