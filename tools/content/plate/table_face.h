#pragma once

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double hole_pitch = 25.0 * mm;

// The face of an optical table: ground steel with threaded holes, each in the middle of a square of the
// pitch. Pictures of `pitches` by `pitches` of them, which go on where they end.
Pictures table_face(int pitches);

}  // namespace fulcrum::content
