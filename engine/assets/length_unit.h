#pragma once
// The units of length that models are made in.

#include "haptics/math/names_of.h"

namespace fulcrum {

enum class LengthUnit { m, cm, mm, um, in, ft };

constexpr double metres(LengthUnit unit) {
  constexpr double kMetres[] = {1, 1e-2, 1e-3, 1e-6, 0.0254, 0.3048};
  return kMetres[static_cast<std::size_t>(unit)];
}

}  // namespace fulcrum

template <>
inline constexpr std::array<std::string_view, 6> fulcrum::names_of<fulcrum::LengthUnit>{"m",  "cm", "mm",
                                                                                        "um", "in", "ft"};
