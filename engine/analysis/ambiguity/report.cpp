#include "engine/analysis/ambiguity/report.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::analysis::ambiguity {
namespace {

using report::short_number;

constexpr std::size_t kShown = 10;

std::string percent(double part) {
  return short_number(100 * part, 3) + " %";
}

std::vector<std::string> cells(const std::string& name, const PointScore& score, const Vec3& p_MT) {
  const Vec3 p_M = 1e3 * (score.p_T + p_MT);
  const auto whole = [](double mm) { return short_number(std::round(10 * mm) / 10, 4); };
  return {name,
          whole(p_M.x()) + ", " + whole(p_M.y()) + ", " + whole(p_M.z()),
          percent(score.alike),
          percent(score.confused),
          short_number(1e3 * score.mistaken, 3),
          percent(score.without_axis)};
}

}  // namespace

report::Csv ambiguity_csv(const AmbiguityStudy& study) {
  report::Csv csv({"point", "x_m", "y_m", "z_m", "alike", "confused", "mistaken_m", "without_axis"});
  const auto row = [&](std::string_view name, const PointScore& score) {
    const Vec3 p_M = score.p_T + study.p_MT;
    csv.row(
        {name, p_M.x(), p_M.y(), p_M.z(), score.alike, score.confused, score.mistaken, score.without_axis});
  };
  row("handle", study.handle);
  for (const PointScore& score : study.others) row("surface", score);
  return csv;
}

report::Table ambiguity_table(const AmbiguityStudy& study) {
  report::Table table{{"held at", "x, y, z (mm)", "feel alike", "confused", "mistaken by (mm)", "no axis"},
                      {}};
  table.rows.push_back(cells("the handle", study.handle, study.p_MT));
  for (std::size_t i = 0; i < std::min(kShown, study.others.size()); ++i)
    table.rows.push_back(cells("place " + std::to_string(i + 1), study.others[i], study.p_MT));
  return table;
}

report::Page ambiguity_page(const AmbiguityStudy& study) {
  report::Page page("Which impacts feel alike: " + study.scenario);
  page.command(study.command);
  page.note(
      "A model, of no person: that axes within 5 degrees feel the same is the paper's; that frequencies need "
      "a ratio "
      "of " +
      short_number(study.desc.frequency_apart) + " is assumed.");
  page.paragraph(
      "The vibration of an impact tells by its axis in which direction from the hand it fell, and by its "
      "frequency how "
      "far away. Impacts on the circle at right angles to the axis feel the same where they are as far from "
      "the hand. "
      "Each place on the tool's surface is struck here along its own normal, and compared with every other "
      "that is "
      "10 mm or more away: 'feel alike' is how many of those feel the same, 'confused' how many places have "
      "such a "
      "twin, and 'mistaken by' how far the twins lie apart. 'No axis': the blow goes through the hand, and "
      "the "
      "vibration is a force.");
  page.facts({{"places struck", std::to_string(study.sites)},
              {"places to hold it that were tried", std::to_string(study.others.size())},
              {"material", short_number(study.desc.frequency_Hz) + " Hz beside the hand"}});
  page.heading("Where to hold it");
  page.table(ambiguity_table(study));
  page.paragraph(
      "Places are in the frame of the tool's model. grasp.position in the scenario puts the handle.");
  return page;
}

}  // namespace fulcrum::analysis::ambiguity
