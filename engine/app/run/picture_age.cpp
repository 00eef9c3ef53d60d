#include "engine/app/run/picture_age.h"

#include <algorithm>
#include <cctype>

#include "engine/report/axis.h"

namespace fulcrum::app {
namespace {

std::string capital(std::string_view name) {
  std::string text(name);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

report::Series curve(std::string name, const record::StageFigures& stage, int hue) {
  report::Series series{.name = std::move(name), .points = {}, .line = report::Line::solid, .hue = hue};
  for (const auto& [ms, part] : stage.within) series.points.push_back({ms, 100 * part});
  return series;
}

}  // namespace

session::PictureAge picture_age(const record::HandToPixel& figures) {
  session::PictureAge age{{{"", "Median (ms)", "99 % within (ms)", "Longest (ms)"}, {}, false},
                          {.title = "How old the tool is when it is shown",
                           .x = {"Age", "ms", report::Scale::linear, 0.0, {}},
                           .y = {"Pictures", "%", report::Scale::linear, 0.0, 100.0},
                           .cells = {},
                           .series = {},
                           .labels = {},
                           .height = 170}};
  for (std::size_t i = 0; i < record::kStageNames.size(); ++i) {
    const record::StageFigures& stage = figures.stages[i];
    const bool whole = i + 1 == record::kStageNames.size();
    std::string name = whole ? "In all" : capital(record::kStageNames[i]);
    age.stages.rows.push_back({name, report::short_number(stage.p50_ms, 3),
                               report::short_number(stage.p99_ms, 3), report::short_number(stage.max_ms, 3)});
    age.frames.series.push_back(curve(std::move(name), stage, whole ? report::kInk : static_cast<int>(i)));
    age.frames.series.back().strong = whole;
  }
  return age;
}

}  // namespace fulcrum::app
