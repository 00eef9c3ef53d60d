#pragma once
// Where the pegs are. The bar, held at the origin of W and pointing along -z, is in a corridor: at each of
// three stations a peg stands above it, below it, at its left and at its right. A row of five stands beside
// the corridor.

#include <array>
#include <vector>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double peg_radius = 5.0 * mm;

struct PegStation {
  const char* material;  // of its pegs
  double z = 0.0;        // m
  double room = 0.0;     // m, from the bar's axis to each of its pegs' surfaces
};

// The middle one is the narrowest, so that a level bar meets it alone; the others are met by a tilted one.
inline constexpr std::array<PegStation, 3> stations_of_bar{
    {{"rubber", -78.0 * mm, 34.0 * mm}, {"wood", -163.0 * mm, 30.0 * mm}, {"steel", -252.0 * mm, 40.0 * mm}}};

inline constexpr double row_x = 76.0 * mm;
inline constexpr double row_top = -16.0 * mm;  // y
inline constexpr std::array<double, 5> row_z{-84.0 * mm, -125.0 * mm, -166.0 * mm, -207.0 * mm, -248.0 * mm};

// The right pegs' round ends are so high; over them the bar leaves the corridor, under the ones above.
inline constexpr double right_top = 11.0 * mm;  // y

Model make_steel_pegs();
Model make_wooden_pegs();
Model make_rubber_pegs();

// The boards that they stand on, and what those stand on.
Model make_boards();

inline constexpr double bench_height = -115.0 * mm;  // y

}  // namespace fulcrum::content
