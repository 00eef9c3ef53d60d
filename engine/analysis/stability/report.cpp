#include "engine/analysis/stability/report.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/stability/figures.h"

namespace fulcrum::analysis::stability {
namespace {

using report::short_number;

constexpr double kTypicalStiffness = 500;  // N/m, for which Diolaiti's figures are listed
constexpr int kDigits = 3;                 // the simulated borders are found to half a per cent

std::string number(double value) {
  return short_number(value, kDigits);
}

std::string at_damping(double K, double B) {
  return number(K) + " at B = " + number(B);
}

const char* region_name(DiolaitiRegion region) {
  switch (region) {
    case DiolaitiRegion::settles:
      return "settles";
    case DiolaitiRegion::limit_cycle:
      return "trembles";
    case DiolaitiRegion::settles_if_slow:
      return "settles if slow";
    case DiolaitiRegion::grows:
      return "grows";
  }
  return "";
}

// Without friction and encoder counts there is nothing that could hold what is slow: damping alone decides.
std::string region_text(const DeviceAxis& axis, const DiolaitiPlace& place) {
  if (axis.linear()) return place.beta > 0.5 ? "settles" : "grows";
  return region_name(diolaiti_region(place));
}

// Largest |simulated / exact - 1| over the borders of the linear devices.
double largest_deviation(const StabilityStudy& study) {
  double largest = 0;
  for (const NamedAxis& device : study.devices) {
    for (const Border& border : study.borders)
      if (border.device == device.name && device.axis.linear() && border.K_exact > 0)
        largest = std::max(largest, std::abs(border.K_simulated / border.K_exact - 1));
  }
  return largest;
}

report::Table device_table(const StabilityStudy& study) {
  const std::string where = "at " + number(kTypicalStiffness) + " N/m";
  report::Table table{{"device", "mass (kg)", "damping (N s/m)", "friction (N)", "encoder step (µm)",
                       "β " + where, "σ " + where, "in theory, " + where},
                      {}};
  for (const NamedAxis& device : study.devices) {
    const DeviceAxis& axis = device.axis;
    const DiolaitiPlace place = diolaiti_place({.axis = axis, .tick_s = kStudyTick}, kTypicalStiffness);
    table.rows.push_back({device.name, number(axis.mass), number(axis.damping), number(axis.friction),
                          number(1e6 * axis.encoder_step), number(place.beta),
                          axis.linear() ? "" : number(place.sigma), region_text(axis, place)});
  }
  return table;
}

report::Table tick_table(const StabilityStudy& study) {
  report::Table table{{"tick (ms)", "simulated (N/m)", "exact (N/m)", "passive (N/m)"}, {}};
  for (const TickLimit& limit : study.ticks)
    table.rows.push_back({number(1e3 * limit.tick_s), number(limit.K_simulated), number(limit.K_exact),
                          number(limit.K_passive)});
  return table;
}

report::Table speed_table(const std::vector<SpeedLimit>& limits) {
  report::Table table{{"speed at the wall (m/s)", "settles below (N/m)"}, {}};
  for (const SpeedLimit& limit : limits) table.rows.push_back({number(limit.v0), number(limit.K_simulated)});
  return table;
}

void say_how(report::Page& page) {
  page.command("fulcrum stability");
  page.paragraph(
      "A wall is a spring K and a damper B that a computer works out once a tick and holds until the next. "
      "Holding a spring's force makes energy, as damping of -K T/2 would, and more with every tick of delay. "
      "The device's own damping b and friction have to eat it; where they cannot, the wall buzzes or throws "
      "the hand off. This page shows how stiff a wall each device can hold, found in three ways.");
  page.paragraph(
      "Simulated: the simulated device (the one that headless runs use: its friction is solved from event to "
      "event, its encoders count in steps, its force is held) is pushed into the wall in no hand. A linear "
      "device counts as stable where its swing decays; one with friction and encoder counts, where a swing "
      "that begins at " +
      short_number(kStudySpeed) +
      " m/s is smaller in its last third than in its first. Its force limit is lifted: a clamp bounds what "
      "diverges and makes nothing stable. The border is found by bisection, to half a per cent.");
  page.paragraph(
      "Exact: the eigenvalues of the linear loop, with mass and damper under a hold, velocity by backward "
      "difference and one state for each tick of delay. It knows neither friction nor encoder counts.");
  page.paragraph(
      "Passive: Colgate and Schenkel's condition b > K T/2 + |B|, and its form for delay. A passive wall "
      "gives out no energy at any frequency, so that no hand that is passive itself can make it unstable; a "
      "wall that is merely stable is so with nobody holding it.");
}

void say_plane(report::Page& page, const StabilityStudy& study) {
  page.heading("The plane of stiffness and damping");
  page.plot(
      plane_plot(study),
      "Filled: growth rate of the simulated swing, blue where it decays. The dots are the border found by "
      "bisection of the same simulation, the black line the exact one.");
  page.paragraph(
      "Over all devices without friction, damping and delays below, the simulated border is within " +
      number(100 * largest_deviation(study)) +
      " % of the exact one. Theory and simulation part only where they ask different questions: "
      "damping in the wall steadies the device that is let go, up to many times the stiffness, but "
      "every N s/m of it is lost to passivity, since at the highest frequency a tick can show the "
      "backward difference answers half a turn late and pushes along with the motion.");
}

void say_delay(report::Page& page, const StabilityStudy& study) {
  page.heading("Delay, over all damping");
  for (const NamedAxis& device : study.devices) {
    page.plot(
        border_plot(study, device.name),
        device.axis.linear()
            ? "Lines: exact. Dashed: passive, up to where B is the device's own damping. B = 0 is in "
              "stability.csv."
            : "Lines: the same device without friction and encoder counts. At little damping friction "
              "holds far more, because it eats what a slow swing makes; where the wall's damper does the "
              "work it counts for little.");
  }
}

void say_rest(report::Page& page, const StabilityStudy& study) {
  page.heading("The tick");
  page.plot(tick_plot(study),
            "A stall is a long tick: a force that is held through 60 ms leaves next to nothing.");
  page.table(tick_table(study));

  page.heading("Energy");
  page.plot(energy_plot(study), "By the passivity observer, at the wall alone; a swing from " +
                                    short_number(kStudySpeed) +
                                    " m/s. Falling: the wall makes energy. K in N/m, B in N s/m.");
  page.paragraph(
      "Every held spring makes energy, a stable one too: at 900 N/m the device's own damping, which is not "
      "in "
      "this figure, eats more than the wall makes, and at 1100 N/m no longer. A wall with a damper of its "
      "own "
      "makes next to nothing in this swing even where it is not passive: what it gives, it gives at far "
      "higher "
      "frequencies, where a loose handle or a tense hand may find it.");

  page.heading("Friction and encoder counts");
  for (std::size_t i = 0; i < study.devices.size(); ++i) {
    if (study.speeds[i].empty()) continue;
    page.plot(
        speed_plot(study, i),
        "Friction takes the same from every swing, the hold makes more the farther it goes: a wall that "
        "holds a slow hand throws a fast one. B = 0, no delay.");
    page.table(speed_table(study.speeds[i]));
  }
  page.plot(
      diolaiti_plot(study),
      "Simulated from a slow start (5 encoder counts of swing) and a fast one (2000), the wall's zero "
      "between two counts. f_c is Coulomb friction, D an encoder count. Dashed: the borders of Diolaiti, "
      "Niemeyer, Barbagli and Salisbury (2006), which are for the worst case; simulated swings also find "
      "rest beyond them.");
}

}  // namespace

report::Csv stability_csv(const StabilityStudy& study) {
  report::Csv csv({"device", "delay_ticks", "B", "K_simulated", "K_exact", "K_passive"});
  for (const Border& border : study.borders)
    csv.row({border.device, static_cast<double>(border.delay_ticks), border.B, border.K_simulated,
             border.K_exact, border.K_passive});
  return csv;
}

report::Table z_width_table(const StabilityStudy& study) {
  report::Table table{
      {"device", "delay (ticks)", "stable, simulated (N/m)", "stable, exact (N/m)", "passive (N/m)"}, {}};
  for (const ZWidth& width : z_widths(study.borders)) {
    table.rows.push_back({width.device, std::to_string(width.delay_ticks),
                          at_damping(width.simulated.K_simulated, width.simulated.B),
                          at_damping(width.exact.K_exact, width.exact.B),
                          at_damping(width.passive.K_passive, width.passive.B)});
  }
  return table;
}

report::Page stability_page(const StabilityStudy& study) {
  report::Page page("How stiff a wall a device can hold");
  say_how(page);
  page.heading("The widest range");
  page.paragraph(
      "Z-width: the stiffest wall of each kind, over the dampings that were tried, at a tick of " +
      short_number(1e3 * kStudyTick) +
      " ms. 'linear' is a device without its friction and encoder counts. stability.csv holds every border.");
  page.table(z_width_table(study));
  page.table(device_table(study));
  say_plane(page, study);
  say_delay(page, study);
  say_rest(page, study);
  return page;
}

}  // namespace fulcrum::analysis::stability
