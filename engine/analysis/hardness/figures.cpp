#include "engine/analysis/hardness/figures.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <tuple>

#include "haptics/math/functions.h"

namespace fulcrum::analysis::hardness {
namespace {

using report::Line;
using report::Marker;
using report::Plot;
using report::Scale;
using report::Series;
using report::short_number;

struct Look {
  int hue;
  Line line;
};

Look look_of(PulseMethod method) {
  switch (method) {
    case PulseMethod::force_only:
      return {report::kInk, Line::solid};
    case PulseMethod::force_only_spare:
      return {6, Line::dashed};
    case PulseMethod::algorithm1:
      return {1, Line::solid};
    default:
      return {0, Line::solid};
  }
}

Series series_of(PulseMethod method) {
  const auto [hue, line] = look_of(method);
  Series series;
  series.name = title_of(method);
  series.line = line;
  series.hue = hue;
  return series;
}

}  // namespace

Plot moment_plot(const HardnessStudy& study) {
  Plot plot;
  plot.title = "Felt moment against the stylus' angle";
  plot.x = {"angle φ between normal and stylus", "°", Scale::linear, 0.0, 90.0};
  plot.y = {"felt moment", "N m", Scale::linear, 0.0, {}};
  Series own{"the contact's own: never more than this", {}, Line::dotted, Marker::none, 2, true};
  double most = 0;
  for (const AngleCurve& curve : study.angles) {
    if (curve.speed != study.setting.speed) continue;
    if (curve.method == PulseMethod::force_only_spare && !study.spare_motors) continue;
    Series series = series_of(curve.method);
    for (const AngleCurve::At& at : curve.at) {
      series.points.push_back({at.phi_deg, at.felt_moment});
      most = std::max(most, at.felt_moment);
    }
    plot.series.push_back(series);
  }
  plot.y.high = 1.1 * most;
  for (double phi_deg = 0; phi_deg <= 90; phi_deg += 0.5) {
    const double moment =
        study.setting.lever * study.setting.wanted_force() * math::sin(phi_deg * std::numbers::pi / 180);
    if (moment > 3 * most) break;
    own.points.push_back({phi_deg, moment});
  }
  plot.series.push_back(own);
  return plot;
}

Plot speed_plot(const HardnessStudy& study) {
  Plot plot;
  plot.title = "How much harder, against the stylus' angle and the speed";
  plot.x = {"angle φ between normal and stylus", "°", Scale::linear, 0.0, 90.0};
  plot.y = {"felt hardness over force only", "", Scale::linear, {}, {}};
  constexpr Line lines[] = {Line::solid, Line::dashed, Line::dotted};
  std::vector<double> speeds;
  for (const AngleCurve& curve : study.angles) {
    if (std::find(speeds.begin(), speeds.end(), curve.speed) == speeds.end()) speeds.push_back(curve.speed);
    const bool fastest = curve.speed == study.setting.speed;
    if (curve.method == PulseMethod::force_only ||
        (curve.method == PulseMethod::force_only_spare && !(fastest && study.spare_motors)))
      continue;
    Series series = series_of(curve.method);
    series.name += ", " + short_number(curve.speed, 3) + " m/s";
    series.line = lines[(speeds.size() - 1) % std::size(lines)];
    for (const AngleCurve::At& at : curve.at) series.points.push_back({at.phi_deg, at.gain.hardness});
    plot.series.push_back(series);
  }
  return plot;
}

Plot lean_plot(const HardnessStudy& study) {
  Plot plot;
  plot.title = "A surface that faces up: felt moment against the side to which the stylus leans, φ = 45°";
  plot.x = {"lean, right-handed about the normal; 0: towards the person", "°", Scale::linear, 0.0, 360.0};
  plot.y = {"felt moment", "N m", Scale::linear, {}, {}};
  Series force = series_of(PulseMethod::force_only), algorithm1 = series_of(PulseMethod::algorithm1),
         exact = series_of(PulseMethod::exact);
  Series printed{"Algorithm 1 with the sign as printed", {}, Line::dashed, Marker::none, 3};
  const Vec3 n = Vec3::UnitY();
  for (const TiltSample& at : study.leans) {
    const Strike strike{n, kPhi * std::numbers::pi / 180, at.lean_deg * std::numbers::pi / 180};
    const Vec3 own = strike.p_HG_D(1).cross(n).normalized();  // below 0: the other way than a contact's
    force.points.push_back({at.lean_deg, at.force_only.moment_D.dot(own)});
    printed.points.push_back({at.lean_deg, at.as_printed.moment_D.dot(own)});
    algorithm1.points.push_back({at.lean_deg, at.algorithm1.moment_D.dot(own)});
    exact.points.push_back({at.lean_deg, at.exact.moment_D.dot(own)});
  }
  plot.series = {force, printed, algorithm1, exact};
  for (const PaperAxis& axis : study.axes) {
    if (!axis.nhat_D.isApprox(n)) continue;
    const double turns = axis.lean / (2 * std::numbers::pi);
    const double lean_deg = 360 * (turns - std::floor(turns));
    plot.series.push_back(
        {"where the stylus is",
         {{lean_deg, axis.algorithm1.moment_D.norm()}, {lean_deg, axis.exact.moment_D.norm()}},
         Line::none,
         Marker::diamond,
         report::kInk,
         true});
  }
  return plot;
}

Plot front_plot(const HardnessStudy& study) {
  Plot plot;
  plot.title = "The front between force and moment, φ = 45°";
  plot.x = {"felt force", "N", Scale::linear, 0.0, {}};
  plot.y = {"felt moment", "N m", Scale::linear, 0.0, {}};
  // Markers in the colour of their direction; what they are, in the legend alone.
  const std::tuple<const char*, Marker, PulseOutcome Front::*> kinds[] = {
      {"force only", Marker::circle, &Front::force_only},
      {"Algorithm 1", Marker::square, &Front::algorithm1},
      {"exact, weight 1", Marker::diamond, &Front::exact}};
  for (std::size_t i = 0; i < study.fronts.size(); ++i) {
    const Front& front = study.fronts[i];
    const int hue = static_cast<int>(i);
    Series line{front.name, {}, Line::solid, Marker::none, hue};
    for (const FrontAt& at : front.at) line.points.push_back({at.force, at.moment});
    plot.series.push_back(line);
  }
  for (const auto& [name, marker, felt] : kinds) {
    plot.series.push_back({name, {}, Line::none, marker, report::kInk});
    for (std::size_t i = 0; i < study.fronts.size(); ++i) {
      const PulseOutcome& at = study.fronts[i].*felt;
      plot.series.push_back(
          {"", {{at.force, at.moment_D.norm()}}, Line::none, marker, static_cast<int>(i), true});
    }
  }
  return plot;
}

Plot cost_plot(const HardnessStudy& study) {
  Plot plot;
  plot.title = "What is missing of the felt wrench, against processor time";
  plot.x = {"processor time of a tick's allocation", "µs", Scale::linear, 0.0, {}};
  plot.y = {"missing, of what was wanted", "%", Scale::linear, {}, {}};
  constexpr Marker markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
  for (std::size_t i = 0; i < study.checks.costs.size(); ++i) {
    const MethodCost& cost = study.checks.costs[i];
    Series series = series_of(cost.method);
    series.marker = markers[i % std::size(markers)];
    series.points = {{cost.median_us, 100 * cost.missing}, {cost.p99_us, 100 * cost.missing}};
    plot.series.push_back(series);
  }
  return plot;
}

}  // namespace fulcrum::analysis::hardness
