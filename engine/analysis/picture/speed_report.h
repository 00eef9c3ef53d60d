#pragma once
// How long a picture takes at each quality level and size.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::picture {

inline constexpr std::string_view kSpeedCsvName = "speed.csv", kSpeedPageName = "speed.html";

struct SpeedFigures {
  std::string scene, view;
  std::uint32_t width = 0, height = 0;   // pixels
  std::vector<std::string> qualities;    // of each level in words, from the best to the cheapest
  std::vector<double> frame_ms;          // of each level, the median of a few frames
  std::vector<std::uint64_t> triangles;  // of each level, that its camera sees
};

// scene, view, width, height, level, triangles, frame_ms; level: 0 is the best
report::Csv speed_csv(const std::vector<SpeedFigures>& all);
// A line a scene and size: frames a second at each level.
report::Table speed_table(const std::vector<SpeedFigures>& all);
// command: what makes the page again.
report::Page speed_page(const std::vector<SpeedFigures>& all, std::string_view command);

}  // namespace fulcrum::analysis::picture
