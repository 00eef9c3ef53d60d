#include "tools/content/knock/route.h"

#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/knock/bar.h"
#include "tools/content/knock/pegs.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double slope = 0.17;     // of the bar, where one end is to meet its pegs before the middle does
constexpr double run = 15.0 * mm;  // of the bar, before it meets a peg
constexpr double over_row = 21.0 * mm;  // y, between the right pegs and the ones above
constexpr double down = 0.18;           // s: it meets the pegs with 0.15 m/s
constexpr double travel = 0.4;          // s, from one place to the next
constexpr double rest = 0.2;            // s
constexpr double end_sphere = 8.0 * mm;
constexpr double sphere = 4.0 * mm;  // radius of a checkpoint

// The bar points along -z, turned towards `motion` by the slope.
Eigen::Matrix3d turned(const Vector3d& motion_W, double rise) {
  const Vector3d rod = (-Vector3d::UnitZ() + rise * motion_W).normalized();
  return Eigen::Quaterniond::FromTwoVectors(-Vector3d::UnitZ(), rod).toRotationMatrix();
}

Knock at_station(std::size_t i, const std::string& from, const char* peg, const Vector3d& motion_W) {
  const PegStation& station = stations_of_bar[i];
  const double rise = (static_cast<double>(i) - 1.0) * slope;  // the near end, neither, the far end
  Knock knock{.name = std::string(station.material) + " from " + from,
              .pegs = std::string(station.material) + "/" + peg,
              .X_WT = Eigen::Isometry3d::Identity(),
              .motion_W = motion_W,
              .run = run};
  knock.X_WT.linear() = turned(motion_W, rise);
  // A tilted bar is wider across its tilt.
  const double reach = station.room - bar_radius * math::hypot(1.0, rise);
  knock.X_WT.translation() = (reach + station.z * rise) * motion_W;
  return knock;
}

// What a knock is called in the mirror image of the scene; empty: the same.
std::string mirrored(std::string name) {
  const auto replaced = [&name](const std::string& side, const std::string& other) {
    const std::size_t at = name.find(side);
    if (at != std::string::npos) name.replace(at, side.size(), other);
    return at != std::string::npos;
  };
  return replaced("the right", "the left") || replaced("the left", "the right") ? name : "";
}

}  // namespace

std::vector<Knock> make_knocks() {
  std::vector<Knock> knocks;
  for (std::size_t i = 0; i < stations_of_bar.size(); ++i) {
    knocks.push_back(at_station(i, "above", "below", -Vector3d::UnitY()));
    knocks.push_back(at_station(i, "below", "above", Vector3d::UnitY()));
    knocks.push_back(at_station(i, "the right", "left", -Vector3d::UnitX()));
    knocks.push_back(at_station(i, "the left", "right", Vector3d::UnitX()));
  }
  const double meets = row_top + bar_radius;
  Knock row{.name = "row of five",
            .pegs = "steel/row/",
            .X_WT = Eigen::Isometry3d::Identity(),
            .motion_W = -Vector3d::UnitY(),
            .run = over_row - meets};
  row.X_WT.translation() = Vector3d(row_x, meets, 0.0);
  knocks.push_back(row);
  // Two at each station, all four directions among them: a list of all would be too long to be read.
  for (const std::size_t i : {0U, 2U, 5U, 7U, 8U, 11U, 12U}) knocks[i].counts = true;
  return knocks;
}

std::vector<RoutePose> make_route(const std::vector<Knock>& knocks, double press) {
  std::vector<RoutePose> route;
  const auto go = [&](const std::string& note, const Eigen::Isometry3d& X_WT, double time, double dwell) {
    route.push_back({.note = note, .X_WT = X_WT, .travel = route.empty() ? 0.0 : time, .dwell = dwell});
  };
  const auto at = [](double x, double y) { return Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.0)); };
  go("start", at(0.0, 0.0), 0.0, 0.5);
  for (const Knock& knock : knocks) {
    const bool is_row = &knock == &knocks.back();
    const auto along = [&](double way) { return Eigen::Translation3d(way * knock.motion_W) * knock.X_WT; };
    if (is_row) {
      go("up, and over the right pegs", at(0.0, over_row), travel, 0.0);
      go("", along(-knock.run), 2.0 * travel, rest);
    } else {
      go("before: " + knock.name, along(-knock.run), travel, rest);
    }
    go(knock.name, along(press), down * std::sqrt(knock.run / run), 0.0);
    route.back().presses = true;
    go("", along(-knock.run), travel, 0.0);
    if (!is_row) go("", at(0.0, 0.0), travel, 0.0);
  }
  return route;
}

std::string knocks_yaml(const std::vector<Knock>& knocks) {
  std::string text;
  for (const Knock& knock : knocks)
    if (knock.counts)
      text += checkpoint_yaml(knock.name, knock.X_WT * bar_middle, sphere, mirrored(knock.name));
  // A run ends with the last checkpoint: it is over the row, so that the last knock is felt to its end.
  const Knock& last = knocks.back();
  return text + checkpoint_yaml("off again", last.X_WT * bar_middle - last.run * last.motion_W, end_sphere);
}

}  // namespace fulcrum::content
