#include "engine/analysis/ambiguity/ambiguity.h"

#include <algorithm>
#include <functional>

#include "haptics/effects/impact_vibration/distance_model.h"
#include "haptics/effects/impact_vibration/impact_vibration.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::ambiguity {
namespace {

// What an impact feels like.
struct Percept {
  Vec3 axis;  // (3) unit; of the force where there is no moment
  bool turns;
  double frequency_Hz;
};

std::vector<Percept> felt_from(std::span<const ImpactSite> sites, const Vec3& p_T,
                               const AmbiguityDesc& desc) {
  double reach = 0;
  for (const ImpactSite& site : sites) reach = std::max(reach, (site.p_T - p_T).norm());
  std::vector<Percept> felt;
  for (const ImpactSite& site : sites) {
    const Vec3 p = site.p_T - p_T, lever = p.cross(site.nhat_T);
    const double r = p.norm();
    const bool turns = lever.norm() > kParallel * r;
    const VibrationModes modes = vibration_modes(DistanceModel::sinusoid, desc.frequency_Hz, r, reach);
    felt.push_back({turns ? Vec3(lever.normalized()) : site.nhat_T, turns, modes.modes[0].frequency_Hz});
  }
  return felt;
}

}  // namespace

PointScore score_point(std::span<const ImpactSite> sites, const Vec3& p_T, const AmbiguityDesc& desc) {
  const std::vector<Percept> felt = felt_from(sites, p_T, desc);
  const double same_axis = math::cos(desc.axis_apart);
  PointScore score;
  score.p_T = p_T;
  double pairs = 0, distance = 0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    bool confused = false;
    for (std::size_t j = 0; j < sites.size(); ++j) {
      if (felt[i].turns != felt[j].turns || felt[i].axis.dot(felt[j].axis) < same_axis) continue;
      const double higher = std::max(felt[i].frequency_Hz, felt[j].frequency_Hz);
      const double lower = std::min(felt[i].frequency_Hz, felt[j].frequency_Hz);
      const double apart = (sites[i].p_T - sites[j].p_T).norm();
      if (higher > desc.frequency_apart * lower || apart < desc.place_apart) continue;
      confused = true;
      pairs += 1;
      distance += apart;
    }
    score.confused += confused ? 1 : 0;
    score.without_axis += felt[i].turns ? 0 : 1;
  }
  const auto count = static_cast<double>(sites.size());
  if (pairs > 0) score.mistaken = distance / pairs;
  if (count > 0) score.confused /= count;
  if (count > 0) score.without_axis /= count;
  if (count > 1) score.alike = pairs / (count * (count - 1));
  return score;
}

std::vector<PointScore> rank_points(std::span<const ImpactSite> sites, std::span<const Vec3> candidates_T,
                                    const AmbiguityDesc& desc) {
  std::vector<PointScore> scores;
  for (const Vec3& p_T : candidates_T) scores.push_back(score_point(sites, p_T, desc));
  std::ranges::stable_sort(scores, std::less<>(), &PointScore::alike);
  return scores;
}

}  // namespace fulcrum::analysis::ambiguity
