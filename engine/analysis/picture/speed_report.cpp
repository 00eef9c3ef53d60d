#include "engine/analysis/picture/speed_report.h"

namespace fulcrum::analysis::picture {
namespace {

std::string size_words(const SpeedFigures& figures) {
  return std::to_string(figures.width) + " x " + std::to_string(figures.height);
}

report::Table triangle_table(const std::vector<SpeedFigures>& all) {
  report::Table table{{"scene", "view", "size"}, {}};
  for (std::size_t level = 0; level < all.front().qualities.size(); ++level)
    table.head.push_back("level " + std::to_string(level));
  for (const SpeedFigures& figures : all) {
    table.rows.push_back({figures.scene, figures.view, size_words(figures)});
    for (const std::uint64_t triangles : figures.triangles)
      table.rows.back().push_back(std::to_string(triangles));
  }
  return table;
}

}  // namespace

report::Csv speed_csv(const std::vector<SpeedFigures>& all) {
  report::Csv csv{"scene", "view", "width", "height", "level", "triangles", "frame_ms"};
  for (const SpeedFigures& figures : all)
    for (std::size_t level = 0; level < figures.frame_ms.size(); ++level)
      csv.row({figures.scene, figures.view, static_cast<double>(figures.width),
               static_cast<double>(figures.height), static_cast<double>(level),
               static_cast<double>(figures.triangles[level]), figures.frame_ms[level]});
  return csv;
}

report::Table speed_table(const std::vector<SpeedFigures>& all) {
  report::Table table{{"scene", "view", "size"}, {}};
  for (std::size_t level = 0; level < all.front().qualities.size(); ++level)
    table.head.push_back("level " + std::to_string(level));
  for (const SpeedFigures& figures : all) {
    table.rows.push_back({figures.scene, figures.view, size_words(figures)});
    for (const double frame_ms : figures.frame_ms)
      table.rows.back().push_back(report::short_number(1e3 / frame_ms, 3));
  }
  return table;
}

report::Page speed_page(const std::vector<SpeedFigures>& all, std::string_view command) {
  report::Page page("Frames a second");
  page.command(command);
  page.paragraph(
      "Each scene as it begins, drawn at each quality level into a picture of each size: the scene alone, "
      "without panels and without a window. Levels take turns, frame by frame, so that what else the machine "
      "does slows all of them alike. Times are medians of a few frames in which the tool moves.");
  report::Table levels{{"level", "quality"}, {}, true};
  for (std::size_t level = 0; level < all.front().qualities.size(); ++level)
    levels.rows.push_back({std::to_string(level), all.front().qualities[level]});
  page.table(levels);
  page.heading("Frames a second");
  page.table(speed_table(all));
  page.heading("Triangles");
  page.paragraph("That are in view, at the level of detail that each piece of a mesh is drawn at.");
  page.table(triangle_table(all));
  return page;
}

}  // namespace fulcrum::analysis::picture
