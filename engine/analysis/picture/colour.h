#pragma once
// Colours as FLIP sees them: linear Rec. 709, an opponent space that is linear, too, and CIE L*a*b*.

#include <array>

#include "haptics/math/linear.h"

namespace fulcrum::analysis::picture {

// IEC 61966-2-1: from what a screen is told to linear light, both 0..1.
double decoded(double encoded);
// Relative luminance of linear Rec. 709.
double luminance(const Vec3& linear);

// YyCxCz (FLIP, section 4.1): lightness, red against green, blue against yellow. White is (100, 0, 0).
Vec3 opponent_of(const Vec3& linear);
Vec3 linear_of(const Vec3& opponent);
// CIE 1976 L*a*b*, white as Rec. 709 has it.
Vec3 lab_of(const Vec3& linear);

}  // namespace fulcrum::analysis::picture
