#pragma once
// The names of an enumeration's values, as files, tables and messages have them. They stand beside the
// enumeration, in its order:
//     enum class Method { none, arm };
//     template <>
//     inline constexpr std::array<std::string_view, 2> names_of<Method>{"none", "arm"};

#include <array>
#include <cstddef>
#include <string_view>

namespace fulcrum {

template <class Enum>
inline constexpr std::array<std::string_view, 0> names_of{};

template <class Enum>
requires(!names_of<Enum>.empty()) constexpr std::string_view name_of(Enum value) {
  return names_of<Enum>[static_cast<std::size_t>(value)];
}

}  // namespace fulcrum
