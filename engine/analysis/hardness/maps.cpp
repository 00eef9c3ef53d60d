#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/analysis/hardness/figures.h"

namespace fulcrum::analysis::hardness {
namespace {

using report::Panels;
using report::short_number;

constexpr double kGains[] = {0.98, 1.02, 1.25, 1.6, 2.5};

int gain_band(double gain) {
  return static_cast<int>(std::upper_bound(std::begin(kGains), std::end(kGains), gain) - std::begin(kGains));
}

std::vector<report::Band> gain_bands() {
  return {{"less", -2},    {"as much (2 %)", 0}, {"to × 1.25", 1},
          {"to × 1.6", 2}, {"to × 2.5", 3},      {"above", 4}};
}

std::string degrees(double deg) {
  return "φ = " + short_number(deg) + "°";
}

}  // namespace

Panels sky_panels(const HardnessStudy& study, double Gain::*gain) {
  Panels panels;
  panels.title = gain == &Gain::moment ? "Gain of the felt moment over force only"
                                       : "Gain of the contact force that would feel as strong";
  panels.across = panels.down = kAcross;
  panels.round = true;
  panels.above = "away";
  panels.below = "person";
  panels.bands = gain_bands();
  for (const auto& [method, all_tilts] :
       {std::pair{PulseMethod::algorithm1, false}, std::pair{PulseMethod::exact, false},
        std::pair{PulseMethod::algorithm1, true}, std::pair{PulseMethod::exact, true}}) {
    panels.rows.push_back(std::string(title_of(method)) + (all_tilts ? ", all leans" : ", to person"));
    for (const DirectionMap& map : study.maps) {
      if (map.method != method || map.all_tilts != all_tilts) continue;
      if (panels.rows.size() == 1) panels.columns.push_back(degrees(map.phi_deg));
      std::vector<int> band;
      for (const std::optional<Gain>& cell : map.cells) band.push_back(cell ? gain_band((*cell).*gain) : -1);
      panels.panels.push_back(std::move(band));
    }
  }
  return panels;
}

Panels pose_panels(const HardnessStudy& study) {
  Panels panels;
  panels.title = "Gain of the felt moment over the workspace, φ = 45°";
  panels.across = panels.down = kPosesAcross;
  panels.above = "away";
  panels.below = "person";
  panels.bands = gain_bands();
  constexpr std::size_t per_layer = kPosesAcross * kPosesAcross;
  for (std::size_t y = 0; y < kLayers; ++y)
    panels.columns.push_back(short_number(1e3 * study.poses[y * per_layer].p_DH.y(), 3) + " mm up");
  std::vector<std::pair<const char*, Gain PoseAt::*>> rows{{"Algorithm 1", &PoseAt::algorithm1},
                                                           {"exact", &PoseAt::exact}};
  if (study.spare_motors) rows.emplace_back("spare motors alone", &PoseAt::spare);
  for (const auto& [name, gains] : rows) {
    panels.rows.emplace_back(name);
    for (std::size_t y = 0; y < kLayers; ++y) {
      std::vector<int> band;
      for (std::size_t i = 0; i < per_layer; ++i) {
        const PoseAt& pose = study.poses[y * per_layer + i];
        band.push_back(pose.reached ? gain_band((pose.*gains).moment) : -1);
      }
      panels.panels.push_back(std::move(band));
    }
  }
  return panels;
}

}  // namespace fulcrum::analysis::hardness
