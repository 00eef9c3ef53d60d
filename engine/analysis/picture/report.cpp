#include "engine/analysis/picture/report.h"

#include <array>
#include <cmath>
#include <string>

#include "haptics/math/functions.h"

namespace fulcrum::analysis::picture {
namespace {

using report::Plot;
using report::Scale;
using report::Series;

std::string digits(double value) {
  return report::short_number(value, 3);
}

std::string percent(double share) {
  return report::short_number(std::round(1e3 * share) / 10, 3);
}

std::size_t level_count(const std::vector<ViewFigures>& views) {
  return views.empty() ? 0 : views.front().levels.size();
}

// Over the views; times and their ratios as geometric means, since scenes differ manyfold.
struct LevelMeans {
  double flip_mean = 0, flip_p99 = 0, luminance_error = 0, frame_ms = 0, of_best = 0;
};

LevelMeans means_of(const std::vector<ViewFigures>& views, std::size_t level) {
  LevelMeans means;
  const auto n = static_cast<double>(views.size());
  double log_ms = 0, log_ratio = 0;
  for (const ViewFigures& view : views) {
    const LevelFigures& figures = view.levels[level];
    means.flip_mean += figures.flip_mean / n;
    means.flip_p99 += figures.flip_p99 / n;
    means.luminance_error += std::abs(figures.luminance_error) / n;
    log_ms += math::log(figures.frame_ms) / n;
    log_ratio += math::log(figures.frame_ms / view.levels.front().frame_ms) / n;
  }
  means.frame_ms = math::exp(log_ms);
  means.of_best = math::exp(log_ratio);
  return means;
}

std::string title_of(const ViewFigures& view) {
  return view.scene + ", " + view.view + (view.time_s > 0 ? ", " + digits(view.time_s) + " s" : "");
}

Plot plot_of(const std::vector<ViewFigures>& views) {
  Plot plot;
  plot.title = "Difference over cost";
  plot.x = {"time of a frame, of the best level's", "", Scale::logarithmic, {}, {}};
  plot.y = {"mean FLIP", "", Scale::linear, 0.0, {}};
  constexpr std::array kLines = {report::Line::solid, report::Line::dashed, report::Line::dotted};
  int scene_index = 0;
  std::string scene;
  for (const ViewFigures& view : views) {
    Series series;
    series.name = view.scene == scene ? "" : view.scene;
    scene_index += view.scene == scene || scene.empty() ? 0 : 1;
    scene = view.scene;
    // There are more scenes than hues.
    series.line = kLines[static_cast<std::size_t>(scene_index / report::kHues) % kLines.size()];
    series.faint = true;
    series.hue = scene_index % report::kHues;
    for (const LevelFigures& level : view.levels)
      series.points.push_back({level.frame_ms / view.levels.front().frame_ms, level.flip_mean});
    plot.series.push_back(series);
  }
  Series mean;
  mean.name = "all views";
  mean.line = report::Line::solid;
  mean.marker = report::Marker::circle;
  mean.hue = report::kInk;
  mean.strong = true;
  for (std::size_t level = 0; level < level_count(views); ++level) {
    const LevelMeans means = means_of(views, level);
    mean.points.push_back({means.of_best, means.flip_mean});
    plot.labels.push_back({mean.points.back(), std::to_string(level), report::Side::above});
  }
  plot.series.push_back(mean);
  return plot;
}

report::Table table_of(const ViewFigures& view) {
  report::Table table{
      {"level", "mean FLIP", "99 % of pixels below", "light (%)", "frame (ms)", "of the best level's"}, {}};
  for (std::size_t level = 0; level < view.levels.size(); ++level) {
    const LevelFigures& figures = view.levels[level];
    table.rows.push_back({std::to_string(level), digits(figures.flip_mean), digits(figures.flip_p99),
                          percent(figures.luminance_error), digits(figures.frame_ms),
                          digits(figures.frame_ms / view.levels.front().frame_ms)});
  }
  return table;
}

}  // namespace

report::Csv picture_csv(const std::vector<ViewFigures>& views) {
  report::Csv csv{"scene", "view", "level", "flip_mean", "flip_p99", "luminance_error", "frame_ms"};
  for (const ViewFigures& view : views)
    for (std::size_t level = 0; level < view.levels.size(); ++level) {
      const LevelFigures& figures = view.levels[level];
      csv.row({view.scene, view.view, static_cast<double>(level), figures.flip_mean, figures.flip_p99,
               figures.luminance_error, figures.frame_ms});
    }
  return csv;
}

report::Table level_table(const std::vector<ViewFigures>& views) {
  report::Table table{{"level", "quality", "mean FLIP", "99 % of pixels below", "light off by (%)",
                       "frame (ms)", "of the best level's"},
                      {}};
  for (std::size_t level = 0; level < level_count(views); ++level) {
    const LevelMeans means = means_of(views, level);
    table.rows.push_back({std::to_string(level), views.front().levels[level].quality, digits(means.flip_mean),
                          digits(means.flip_p99), percent(means.luminance_error), digits(means.frame_ms),
                          digits(means.of_best)});
  }
  return table;
}

report::Table view_table(const std::vector<ViewFigures>& views) {
  report::Table table{
      {"scene", "view", "at (s)", "mean FLIP", "99 % of pixels below", "light (%)", "frame (ms)"}, {}};
  for (const ViewFigures& view : views) {
    const LevelFigures& best = view.levels.front();
    table.rows.push_back({view.scene, view.view, digits(view.time_s), digits(best.flip_mean),
                          digits(best.flip_p99), percent(best.luminance_error), digits(best.frame_ms)});
  }
  return table;
}

report::Page picture_page(const std::vector<ViewFigures>& views, std::string_view command) {
  report::Page page("Pictures against a path-traced reference");
  page.command(command);
  page.paragraph(
      "Each quality level draws each scene as a path tracer has drawn it, from the same meshes, materials, "
      "lights and camera, and both pass through the same tone mapping. FLIP is what somebody who alternates "
      "between the two would see, from 0 (nothing) to 1, at 67 pixels a degree: Andersson and others, 2020. "
      "Light is that of the whole picture on the screen, in relation to the reference's: above 0 it is too "
      "bright. Times are medians of a few frames in which the tool moves, on the machine that made this "
      "page: they compare levels, not machines.");
  page.paragraph(
      "A reference has much that no level draws: light that has met more than two surfaces, mirrors in "
      "mirrors, what lies nearer to a metal than a voxel is wide, light through thin parts, and the shadows "
      "of the lamps that models bring; a moving tool hides there all light, not the key light alone, and "
      "is seen in mirrors. Soft edges of shadows, what metal mirrors and light below surfaces are left out "
      "by the cheaper levels alone; the table says by which.");
  for (const ViewFigures& view : views)
    if (view.stale)
      page.note("The reference of " + title_of(view) +
                " was drawn of another state of the scene: make it anew with tools/references.");
  page.heading("Levels, over all views");
  page.table(level_table(views));
  page.plot(plot_of(views), "Lower and further left is better. 0 is the best level. Thin lines are views.");
  page.heading("Views, at the best level");
  page.table(view_table(views));
  for (const ViewFigures& view : views) {
    page.heading(title_of(view));
    page.table(table_of(view));
    std::vector<report::NamedPng> pictures;
    for (const ShownPicture& picture : view.pictures) pictures.push_back({picture.name, picture.png});
    page.pictures(pictures,
                  "The map is black where nothing is seen of a difference and pale where it is largest.");
  }
  return page;
}

}  // namespace fulcrum::analysis::picture
