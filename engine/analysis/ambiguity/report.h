#pragma once
// What a study of manipulation points leaves behind: ambiguity.csv and ambiguity.html.

#include <string>
#include <vector>

#include "engine/analysis/ambiguity/ambiguity.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::ambiguity {

inline constexpr std::string_view kAmbiguityCsvName = "ambiguity.csv", kAmbiguityPageName = "ambiguity.html";

struct AmbiguityStudy {
  std::string scenario, command;
  AmbiguityDesc desc;
  std::size_t sites = 0;
  Vec3 p_MT = Vec3::Zero();        // (3) m, T in the tool model's frame: places are shown in that
  PointScore handle;               // as the scenario has it
  std::vector<PointScore> others;  // ranked
};

// point, x_m, y_m, z_m, alike, confused, mistaken_m, without_axis: the handle, then every other.
report::Csv ambiguity_csv(const AmbiguityStudy& study);
// The handle and the best others.
report::Table ambiguity_table(const AmbiguityStudy& study);
report::Page ambiguity_page(const AmbiguityStudy& study);

}  // namespace fulcrum::analysis::ambiguity
