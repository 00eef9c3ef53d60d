#pragma once
// What a whole tick of the piping scenario costs: step(), from the device's sample to its command.

#include <cstddef>

namespace fulcrum::bench {

struct TickCost {
  double median_us, p99_us;   // of the ticks in contact
  std::size_t ticks;          // that were in contact
  std::size_t limited_ticks;  // of these: the tool could not go all the way to where the hand would have it
  double limited_median_us;
  double regions;      // mean, of the ticks in contact
  double near_points;  // mean: shell points that the constraint has to keep out
  std::size_t shell_points;
  double field_MB;    // of the whole plant
  double bake_cpu_s;  // of the whole plant
};

// The scene is built here from the models that the scenario loads and with the settings that its file gives,
// but for contact.response, which is constraint: the haptic core alone reads no scenario files. The simulated
// hand of a beginner carries the spanner straight at the nut, through the pipes between, and twists it there.
TickCost cost_of_piping_ticks();

}  // namespace fulcrum::bench
