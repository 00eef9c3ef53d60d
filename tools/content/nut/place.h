#pragma once
// Where things are in the scene of the nut. W: the middle of the washer that the nut is to sit on; x to the
// right, y up, z along the bolt to the trainee.

#include "tools/content/mesh/fasteners.h"
#include "tools/content/mesh/metric_thread.h"

namespace fulcrum::content {

inline constexpr MetricThread m12_thread{12.0 * mm, 1.75 * mm};
// ISO 4032, ISO 4014 and ISO 7089.
inline constexpr Thread m12_iso{12.0 * mm, 1.75 * mm, 18.0 * mm, 7.5 * mm, 10.6 * mm, 12.0 * mm, 2.5 * mm};

inline constexpr int thread_sectors = 48;  // facets around: 13 um of sagitta at the crest

inline constexpr double bolt_end = m12_iso.nut_height + 3.0 * mm;  // z; it stands out by nearly two threads
inline constexpr double bolt_foot = -8.0 * mm;                     // z, in the cover
inline constexpr double nut_on_seat = 0.5 * m12_iso.nut_height;    // z of the nut's middle
inline constexpr double nut_at_end = bolt_end + nut_on_seat;       // where its face is at the bolt's end

// The cover's four bolts stand on a circle; the bare one is up and to the right of its middle.
inline constexpr double bolt_circle = 32.5 * mm;
inline constexpr double cover_face = -m12_iso.washer_height;  // z

// The pipe that is in the way runs from the left, level with the bolt, and turns up beside it.
inline constexpr double pipe_radius = 13.45 * mm;
inline constexpr double pipe_z = 48.0 * mm;
inline constexpr double pipe_turns_x = 78.0 * mm;

inline constexpr double wall_face = -150.0 * mm;  // z

}  // namespace fulcrum::content
