#pragma once

#include <string_view>
#include <vector>

#include "engine/analysis/picture/figures.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::picture {

inline constexpr std::string_view kPictureCsvName = "picture.csv", kPicturePageName = "picture.html";

// scene, view, level, flip_mean, flip_p99, luminance_error, frame_ms; level: 0 is the best
report::Csv picture_csv(const std::vector<ViewFigures>& views);
// command: what makes the page again.
report::Page picture_page(const std::vector<ViewFigures>& views, std::string_view command);
// A line a level: means over the views.
report::Table level_table(const std::vector<ViewFigures>& views);
// A line a view: its best level.
report::Table view_table(const std::vector<ViewFigures>& views);

}  // namespace fulcrum::analysis::picture
