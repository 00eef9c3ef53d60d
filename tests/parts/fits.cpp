#include "tests/parts/fits.h"

#include <cmath>
#include <numbers>

#include "tests/parts/content_mesh.h"
#include "tests/parts/flat.h"
#include "tools/content/mesh/metric_thread.h"

namespace fulcrum::parts {
namespace {

constexpr double kPi = std::numbers::pi;

std::string named(const char* what, double millimetres) {
  return std::string(what) + ' ' + std::to_string(std::lround(millimetres)) + " mm";
}

// m, of a diameter: what H7/g6 leaves at the middle of both fields (ISO 286-2).
double play_h7_g6(double diameter) {
  struct Row {
    double up_to, h7, g6_from, g6_to;  // m, and micrometres
  };
  for (const Row& row : {Row{3e-3, 10, 2, 8}, {6e-3, 12, 4, 12}, {10e-3, 15, 5, 14}, {18e-3, 18, 6, 17}})
    if (diameter <= row.up_to) return 1e-6 * (row.h7 / 2 + (row.g6_from + row.g6_to) / 2);
  return 0;
}

// On the outline of a square of that width, at the angles of n points from a corner.
std::vector<Vec2> square(double width, int n) {
  std::vector<Vec2> points = circle(1, n, kPi / 4);
  for (Vec2& p : points) p *= width / 2 / p.cwiseAbs().maxCoeff();
  return points;
}

// A peg half in a block with a hole through it.
Fit peg(const std::string& name, const std::vector<Vec2>& outline, const std::vector<Vec2>& hole, double size,
        double play) {
  Fit fit{.name = name, .clearance = play / 2};
  fit.tool_T = extruded(star(outline), -size, size);
  fit.scene_W = extruded(ring(hole, square(3 * size, static_cast<int>(hole.size()))), -1.5 * size, 0);
  fit.X_WT.p = Vec3(0, 0, 0);
  return fit;
}

Fit round_peg(double d) {
  constexpr int sides = 48;
  const double play = play_h7_g6(d);
  // The hole's facets keep the play: its corners lie farther out.
  const double hole = (d + play) / 2 / std::cos(kPi / sides);
  return peg(named("round peg", 1e3 * d), circle(d / 2, sides, kPi / 4), circle(hole, sides, kPi / 4), d,
             play);
}

Fit square_peg(double d) {
  const double play = play_h7_g6(d);
  return peg(named("square peg", 1e3 * d), square(d, 8), square(d + play, 8), d, play);
}

// Cut off square: this is about threads that hold, not about how they begin.
Fit threaded(double d, double pitch, double across_flats, double height) {
  const content::MetricThread thread{d, pitch};
  Fit fit{.name = "nut M" + std::to_string(std::lround(1e3 * d)),
          .pitch = pitch,
          .clearance = thread_clearance(thread) / 2};
  fit.scene_W = mesh_of(content::threaded_rod(thread, 2.2 * height, content::LeadIn::none, 48));
  fit.tool_T = mesh_of(content::threaded_nut(thread, height, across_flats, content::LeadIn::none, 48));
  // In step with the bolt's thread, half of the axial play up.
  fit.X_WT.p.z() = pitch * std::round(0.6 * height / pitch);
  return fit;
}

// One side of an involute tooth, from the base circle to the tip, as radius and the angle off the middle.
std::vector<Vec2> gear_outline(double module_m, int teeth, double backlash) {
  const double pitch_r = module_m * teeth / 2, base = pitch_r * std::cos(kPi / 9), tip = pitch_r + module_m,
               root = pitch_r - 1.25 * module_m;
  const auto involute = [](double x) { return std::tan(x) - x; };
  const double half_tooth = kPi / 2 / teeth - backlash / 2 / pitch_r;  // rad at the pitch circle
  std::vector<Vec2> outline;
  const auto add = [&](double r, double angle) {
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  };
  constexpr int steps = 5;
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const double middle = 2 * kPi * tooth / teeth;
    const auto angle_at = [&](double r) {
      return half_tooth + involute(kPi / 9) - involute(std::acos(std::min(1.0, base / r)));
    };
    const double from = std::max(base, root);
    add(root, middle - kPi / teeth * 0.9);
    for (int i = 0; i <= steps; ++i) {
      const double r = std::lerp(from, tip, static_cast<double>(i) / steps);
      add(r, middle - angle_at(r));
    }
    for (int i = steps; i >= 0; --i) {
      const double r = std::lerp(from, tip, static_cast<double>(i) / steps);
      add(r, middle + angle_at(r));
    }
    add(root, middle + kPi / teeth * 0.9);
  }
  return outline;
}

// Two spur gears of 20 degrees that mesh; the tool is one of them.
Fit gears() {
  constexpr double module_m = 1e-3, backlash = 60e-6;
  constexpr int teeth = 20;
  const std::vector<Vec2> outline = gear_outline(module_m, teeth, backlash);
  Fit fit{.name = "gear on gear", .clearance = backlash / 2};
  fit.tool_T = extruded(star(outline), -3e-3, 3e-3);
  fit.scene_W = extruded(star(outline), -4e-3, 4e-3);
  const double half_tooth = kPi / teeth;
  fit.X_WT = {Quat(Eigen::AngleAxisd(kPi + half_tooth, Vec3::UnitZ())), Vec3(module_m * teeth + 20e-6, 0, 0)};
  fit.across_W = Vec3::UnitY();
  return fit;
}

// A pin with a head in an eye, which keeps it from both ends: the middle of three knuckles.
Fit hinge() {
  constexpr int sides = 32;
  constexpr double bore = 3.05e-3, pin = 3e-3, knuckle = 8e-3, gap = 50e-6;
  Fit fit{.name = "hinge", .clearance = (bore - pin) / 2};
  fit.scene_W = extruded(star(circle(pin, sides)), -16e-3, 16e-3);
  for (const double side : {-1.0, 1.0})
    append(fit.scene_W, extruded(ring(circle(pin - 0.5e-3, sides), circle(6e-3, sides)),
                                 side > 0 ? knuckle / 2 + gap : -knuckle / 2 - gap - 7e-3,
                                 side > 0 ? knuckle / 2 + gap + 7e-3 : -knuckle / 2 - gap));
  fit.tool_T = extruded(ring(circle(bore / std::cos(kPi / sides), sides), circle(6e-3, sides)), -knuckle / 2,
                        knuckle / 2);
  fit.X_WT.p.z() = 0;
  return fit;
}

// Teeth up; n of them of that width, `pitch` apart.
TriangleMesh comb(int n, double pitch, double width, double depth) {
  std::vector<double> x{-pitch}, low, high;
  for (int i = 0; i < n; ++i) {
    const double at = pitch * i;
    x.insert(x.end(), {at - width / 2, at + width / 2});
    low.insert(low.end(), {-4e-3, -4e-3});
    high.insert(high.end(), {0.0, depth});
  }
  x.push_back(pitch * n);
  low.push_back(-4e-3);
  high.push_back(0);
  return extruded(columns(x, low, high), -5e-3, 5e-3);
}

Fit combs() {
  constexpr int n = 12;
  constexpr double pitch = 4e-3, width = 1.95e-3, depth = 8e-3;
  Fit fit{.name = "comb in comb", .clearance = (pitch / 2 - width) / 2};
  fit.scene_W = comb(n, pitch, width, depth);
  fit.tool_T = comb(n, pitch, width, depth);
  // Upside down, a tooth of the one in each gap of the other.
  fit.X_WT = {Quat(Eigen::AngleAxisd(kPi, Vec3::UnitZ())),
              Vec3(pitch * (n - 1) + pitch / 2, depth + 2e-3, 0)};
  fit.way_W = Vec3::UnitY();
  return fit;
}

// A blade of 2 mm with cut steps in a slot whose pins end in them.
Fit key() {
  constexpr double play = 40e-6;
  const std::vector<double> cuts{5e-3, 3.5e-3, 4.5e-3, 3e-3, 4e-3, 5e-3};
  std::vector<double> x{0}, low, high;
  for (const double cut : cuts) {
    x.push_back(x.back() + 3e-3);
    low.push_back(0);
    high.push_back(cut);
  }
  Fit fit{.name = "key in a lock", .clearance = play};
  fit.tool_T = extruded(columns(x, low, high), -1e-3, 1e-3);
  // The pins above the cuts, the floor below, and a wall on either side: each closed by itself.
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const std::vector<double> pin{x[i] + 1e-3, x[i] + 2e-3};
    append(fit.scene_W, extruded(columns(pin, {cuts[i] + play}, {8e-3}), -0.9e-3, 0.9e-3));
  }
  append(fit.scene_W, extruded(columns({-2e-3, 20e-3}, {-3e-3}, {-play}), -3e-3, 3e-3));
  for (const double side : {-1.0, 1.0})
    append(fit.scene_W, extruded(columns({-2e-3, 20e-3}, {-play / 2}, {8e-3}), side > 0 ? 1e-3 + play : -3e-3,
                                 side > 0 ? 3e-3 : -1e-3 - play));
  fit.way_W = Vec3::UnitX();
  fit.across_W = Vec3::UnitY();
  return fit;
}

}  // namespace

std::vector<Fit> fits() {
  std::vector<Fit> all;
  for (const double d : {4e-3, 8e-3, 16e-3}) {
    all.push_back(round_peg(d));
    all.push_back(square_peg(d));
  }
  // ISO 4032: width across flats and height.
  all.push_back(threaded(4e-3, 0.7e-3, 7e-3, 3.2e-3));
  all.push_back(threaded(8e-3, 1.25e-3, 13e-3, 6.8e-3));
  all.push_back(threaded(12e-3, 1.75e-3, 18e-3, 10.8e-3));
  all.push_back(threaded(20e-3, 2.5e-3, 30e-3, 18e-3));
  all.push_back(gears());
  all.push_back(hinge());
  all.push_back(combs());
  all.push_back(key());
  return all;
}

}  // namespace fulcrum::parts
