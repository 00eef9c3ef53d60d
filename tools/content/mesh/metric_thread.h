#pragma once
// Bolts and nuts to ISO 68-1 (profile) with the tolerances 6g and 6H of ISO 965-1, at the middle of their
// fields. Their surfaces are faceted: `sectors` columns around, each exact.

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

struct MetricThread {
  double diameter = 0.0;  // m
  double pitch = 0.0;     // m, from one thread to the next
  int starts = 1;         // threads side by side

  double lead() const { return starts * pitch; }  // m a turn
};

// m, radial: half of what the mean pitch diameters of a 6H nut and a 6g bolt differ by.
double thread_clearance(const MetricThread& thread);

// How a thread begins.
enum class LeadIn {
  none,       // cut off square
  chamfered,  // a bolt's end turned to 45 degrees (ISO 4753, CH), a nut's bore sunk to 120 degrees (ISO 4032)
};

// A threaded rod about z, from z = 0 to length; the lead-in is at its upper end.
Solid threaded_rod(const MetricThread& thread, double length, LeadIn lead_in, int sectors);

// A hexagon nut about z with its thread, from z = 0 to height, across flats m wide; a lead-in at both ends.
// Six divides the sectors.
Solid threaded_nut(const MetricThread& thread, double height, double across_flats, LeadIn lead_in,
                   int sectors);

}  // namespace fulcrum::content
