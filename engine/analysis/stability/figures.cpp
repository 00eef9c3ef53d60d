#include "engine/analysis/stability/figures.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace fulcrum::analysis::stability {
namespace {

using report::AxisDesc;
using report::Line;
using report::Marker;
using report::Plot;
using report::Scale;
using report::Series;

constexpr const char* kDelayNames[kStudyDelays] = {"no delay", "1 tick late", "2 ticks late"};

AxisDesc stiffness_axis(Scale scale) {
  return {"wall stiffness K", "N/m", scale, {}, {}};
}

AxisDesc damping_axis(Scale scale) {
  return {"wall damping B", "N s/m", scale, {}, {}};
}

struct Lines {
  Series simulated, exact, passive;
};

Lines lines_of(const StabilityStudy& study, const std::string& device, int delay) {
  Lines lines;
  for (const Border& border : study.borders) {
    if (border.device != device || border.delay_ticks != delay) continue;
    lines.simulated.points.push_back({border.B, border.K_simulated});
    lines.exact.points.push_back({border.B, border.K_exact});
    lines.passive.points.push_back({border.B, border.K_passive});
  }
  lines.simulated.line = Line::none;
  lines.simulated.marker = Marker::circle;
  lines.passive.line = Line::dashed;
  return lines;
}

bool has_friction(const StabilityStudy& study, const std::string& device) {
  return std::any_of(
      study.devices.begin(), study.devices.end(),
      [&](const NamedAxis& each) { return each.name == device && !each.axis.linear(); });
}

// Of rates: from far below 0 to far above it.
constexpr double kRates[] = {-30, -10, -3, 0, 3, 10, 30};  // 1/s

int rate_band(double rate) {
  return static_cast<int>(std::upper_bound(std::begin(kRates), std::end(kRates), rate) - std::begin(kRates));
}

std::vector<report::Band> rate_bands() {
  return {{"below −30/s", -4}, {"−30 to −10", -3}, {"−10 to −3", -2}, {"−3 to 0", -1},
          {"0 to 3", 1},       {"3 to 10", 2},     {"10 to 30", 3},   {"above 30/s: grows fast", 4}};
}

}  // namespace

Plot plane_plot(const StabilityStudy& study) {
  Plot plot;
  plot.title = "Which walls a device of " + report::short_number(kReferenceMass) + " kg and " +
               report::short_number(kReferenceDamping) + " N s/m can hold at 1 ms";
  plot.x = damping_axis(Scale::linear);
  plot.y = stiffness_axis(Scale::linear);
  plot.x.high = study.growth.B_edges.back();
  plot.y.high = study.growth.K_edges.back();
  plot.cells = {study.growth.B_edges, study.growth.K_edges, {}, rate_bands()};
  for (const double rate : study.growth.growth) plot.cells.band.push_back(rate_band(rate));
  Lines lines = lines_of(study, study.devices.front().name, 0);
  lines.exact.name = "stable below, exact";
  lines.exact.hue = report::kInk;
  lines.passive.name = "passive below, theory";
  lines.passive.hue = 3;
  lines.passive.strong = true;
  lines.simulated.name = "stable below, simulated";
  lines.simulated.hue = report::kInk;
  plot.series = {lines.exact, lines.passive, lines.simulated};
  Series cases{"examples", {}, Line::none, Marker::diamond, 1, true};
  for (const Wall& wall : {Wall{900, 0}, Wall{600, 0.25}, Wall{4000, 2}, Wall{1100, 0}, Wall{5500, 2}})
    cases.points.push_back({wall.B, wall.K});
  plot.series.push_back(cases);
  plot.labels = {{{0.25, 600}, "stable, not passive", report::Side::right},
                 {{2, 4000}, "stable, not passive", report::Side::below},
                 {{2, 5500}, "unstable", report::Side::left},
                 {{0, 1100}, "unstable", report::Side::above},
                 {{0, 900}, "passive", report::Side::right}};
  return plot;
}

Plot border_plot(const StabilityStudy& study, const std::string& device) {
  Plot plot;
  plot.title = "Stiffest wall against the wall's damping: " + device;
  plot.x = damping_axis(Scale::logarithmic);
  plot.y = stiffness_axis(Scale::logarithmic);
  const bool friction = has_friction(study, device);
  std::vector<Series> passive, simulated;
  for (int delay = 0; delay < kStudyDelays; ++delay) {
    Lines lines = lines_of(study, device, delay);
    const std::string when = kDelayNames[delay];
    lines.exact.name = when + (friction ? ", without friction, exact" : ", exact");
    lines.simulated.name = when + ", simulated";
    lines.passive.name = delay == 0 ? "passive, theory" : "";
    lines.exact.hue = lines.simulated.hue = lines.passive.hue = delay;
    constexpr Marker markers[kStudyDelays] = {Marker::circle, Marker::square, Marker::triangle};
    lines.simulated.marker = markers[delay];
    plot.series.push_back(lines.exact);
    passive.push_back(lines.passive);
    simulated.push_back(lines.simulated);
  }
  plot.series.insert(plot.series.end(), simulated.begin(), simulated.end());
  plot.series.insert(plot.series.end(), passive.begin(), passive.end());
  return plot;
}

Plot tick_plot(const StabilityStudy& study) {
  Plot plot;
  plot.title = "Stiffest wall against the tick, without damping or delay: reference";
  plot.x = {"tick", "ms", Scale::logarithmic, {}, {}};
  plot.y = stiffness_axis(Scale::logarithmic);
  Series exact{"stable below, exact", {}, Line::solid, Marker::none, 0, false};
  Series passive{"passive below, theory", {}, Line::dashed, Marker::none, 3, false};
  Series simulated{"stable below, simulated", {}, Line::none, Marker::circle, 0, false};
  for (const TickLimit& limit : study.ticks) {
    exact.points.push_back({1e3 * limit.tick_s, limit.K_exact});
    passive.points.push_back({1e3 * limit.tick_s, limit.K_passive});
    simulated.points.push_back({1e3 * limit.tick_s, limit.K_simulated});
  }
  plot.series = {exact, passive, simulated};
  return plot;
}

Plot energy_plot(const StabilityStudy& study) {
  Plot plot;
  plot.title = "Energy that has gone into the wall: reference";
  plot.x = {"time", "s", Scale::linear, {}, {}};
  plot.y = {"energy at the port", "mJ", Scale::linear, {}, {}};
  int hue = 0;
  for (const EnergyRun& run : study.energies) {
    Series series{"K " + report::short_number(run.wall.K) + ", B " + report::short_number(run.wall.B),
                  {},
                  Line::solid,
                  Marker::none,
                  hue++,
                  false};
    for (std::size_t i = 0; i < run.energy.size(); ++i)
      series.points.push_back({static_cast<double>(i) * kStudyTick, 1e3 * run.energy[i]});
    plot.series.push_back(std::move(series));
  }
  return plot;
}

Plot speed_plot(const StabilityStudy& study, std::size_t device) {
  Plot plot;
  const NamedAxis& named = study.devices[device];
  plot.title = "Stiffest wall against the speed at which it is met: " + named.name;
  plot.x = {"speed at the wall", "m/s", Scale::logarithmic, {}, {}};
  plot.y = stiffness_axis(Scale::logarithmic);
  Series simulated{"settles below, simulated", {}, Line::solid, Marker::circle, 1, false};
  for (const SpeedLimit& limit : study.speeds[device])
    simulated.points.push_back({limit.v0, limit.K_simulated});
  Series exact{"without friction, exact", {}, Line::dashed, Marker::none, 0, false};
  const auto border = std::find_if(study.borders.begin(), study.borders.end(), [&](const Border& each) {
    return each.device == named.name && each.delay_ticks == 0 && each.B == 0;
  });
  if (border != study.borders.end() && !simulated.points.empty()) {
    exact.points = {{simulated.points.front().x, border->K_exact},
                    {simulated.points.back().x, border->K_exact}};
  }
  plot.series = {simulated, exact};
  return plot;
}

Plot diolaiti_plot(const StabilityStudy& study) {
  Plot plot;
  plot.title = "Friction against encoder counts, damping against the tick";
  plot.x = {"β = b / (K T)", "", Scale::logarithmic, study.diolaiti.beta_edges.front(),
            study.diolaiti.beta_edges.back()};
  plot.y = {"σ = f_c / (K D)", "", Scale::logarithmic, study.diolaiti.sigma_edges.front(),
            study.diolaiti.sigma_edges.back()};
  plot.cells = {study.diolaiti.beta_edges,
                study.diolaiti.sigma_edges,
                {},
                {{"settles", -3}, {"trembles by counts", -1}, {"settles if slow", 1}, {"grows", 3}}};
  for (const Outcome outcome : study.diolaiti.outcome) plot.cells.band.push_back(static_cast<int>(outcome));
  constexpr double half = 0.5;
  plot.series.push_back(
      {"β, σ = 1/2, theory",
       {{half, study.diolaiti.sigma_edges.front()}, {half, study.diolaiti.sigma_edges.back()}},
       Line::dashed,
       Marker::none,
       report::kInk,
       false});
  plot.series.push_back(
      {"",
       {{study.diolaiti.beta_edges.front(), half}, {study.diolaiti.beta_edges.back(), half}},
       Line::dashed,
       Marker::none,
       report::kInk,
       false});
  return plot;
}

}  // namespace fulcrum::analysis::stability
