#pragma once
// Where the needle can be: for every depth of its tip and every angle of roll, the pose with the most room
// about it. From this follow that no fixed roll passes, and the way that does.

#include <string>
#include <vector>

#include "tools/content/ear/room.h"

namespace fulcrum::content {

// Roll is the needle's turn about its own shaft, 0 when the bent end points down; the shaft may lean besides.
inline constexpr int rolls = 36;

struct NeedlePose {
  Eigen::Vector2d aside = Eigen::Vector2d::Zero();  // mm, of the tip, to the front and up
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();   // rad, of the shaft, about x and y
  double roll = 0.0;                                // rad
};

// A place that the tip has to pass, or, where a stop has a name, reach.
struct PassageStation {
  Eigen::Vector3d tip_W;  // mm
  std::string stop{};
};

Eigen::Isometry3d placed(const PassageStation& station, const NeedlePose& pose);  // X_WT, mm

// The needle on its way from one pose to the next, `part` of it done: as a hand moves it, about its centre of
// mass. Lengths in mm.
Eigen::Isometry3d on_the_way(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double part);

class Passage {
public:
  explicit Passage(const Flesh& flesh);

  const std::vector<PassageStation>& stations() const { return stations_; }
  double clearance(std::size_t station, int roll) const;  // mm, of the best pose

  // The most room (mm) that any one roll leaves at the narrowest station of its way, and which.
  struct Fixed {
    double clearance = 0.0;
    int roll = 0;
  };
  Fixed best_fixed_roll() const;

  // The way through all stations, rolling where there is room to; empty if there is none.
  struct Node {
    std::size_t station = 0;
    NeedlePose pose;
  };
  std::vector<Node> way() const;

  // Of any pose, in mm.
  double clearance_at(const Eigen::Isometry3d& X_WT) const;

private:
  struct Cell {
    NeedlePose pose;
    double clearance = -1e3;
  };
  static double preference(const Cell& cell);
  Cell improved(std::size_t station, const NeedlePose& from) const;
  double between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) const;
  const Cell& cell(std::size_t station, int roll) const;

  Room room_;
  std::vector<Ball> needle_;
  std::vector<PassageStation> stations_;
  std::vector<Cell> cells_;  // (stations x rolls)
};

}  // namespace fulcrum::content
