#pragma once

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// Metric fastener of one thread size; DIN 931, DIN 934 (old widths: 19 mm for M12) and DIN 125.
struct Thread {
  double diameter;       // m
  double pitch;          // m
  double across_flats;   // m
  double head_height;    // m
  double nut_height;     // m
  double washer_radius;  // m
  double washer_height;  // m, not below 2 mm: contact needs some thickness
};

inline constexpr Thread m6{6 * mm, 1.0 * mm, 10 * mm, 4.0 * mm, 5.0 * mm, 6.0 * mm, 2.0 * mm};
inline constexpr Thread m8{8 * mm, 1.25 * mm, 13 * mm, 5.3 * mm, 6.5 * mm, 8.0 * mm, 2.0 * mm};
inline constexpr Thread m10{10 * mm, 1.5 * mm, 17 * mm, 6.4 * mm, 8.0 * mm, 10.0 * mm, 2.0 * mm};
inline constexpr Thread m12{12 * mm, 1.75 * mm, 19 * mm, 7.5 * mm, 10.0 * mm, 12.0 * mm, 2.5 * mm};

// How far a bolt stands out beyond its nut.
inline constexpr double stub(const Thread& thread) {
  return 2.4 * thread.pitch;
}

// Hexagon-head bolt: bearing face of the head at z = 0, head towards -z, shank towards +z. The thread is
// cut where it shows, on the last `threaded` metres.
Solid bolt(const Thread& thread, double length, double threaded, int columns);

// Hexagon nut from z = 0 to its height. It has no bore: the bolt runs through it.
Solid nut(const Thread& thread, int columns);

// Washer from z = 0 to its height, without a bore for the same reason.
Solid washer(const Thread& thread, int columns);

}  // namespace fulcrum::content
