#pragma once
// How far a tool is with one checkpoint: at its place, along its line, in its bore, turned by how much. Pure.

#include <optional>

#include "engine/scenario/task.h"
#include "haptics/math/pose.h"

namespace fulcrum::scenario {

class CheckpointWay {
public:
  explicit CheckpointWay(const Checkpoint& checkpoint);

  // Once a tick, wherever the touch point is: is it at the checkpoint? What it has gone of a line, and been
  // turned, stays when it leaves; a bore is begun anew at its mouth.
  bool see(const Vec3& p_WC);
  // Whether it would be, without having been seen there.
  bool holds(const Vec3& p_WC) const;
  // Once a tick in which it is there and what the checkpoint needs is so.
  void go_on(const Vec3& p_WC, const Quat& q_WT);
  // Once a tick in which the tool is not there, or what the checkpoint needs is not so.
  void rest() { q_WT_.reset(); }
  // Once a tick of a pause, in which the tool may go anywhere: that is no slip.
  void pause() {
    rest();
    paused_ = true;
  }

  bool is_done() const { return done() >= 1; }
  double done() const;  // 0 to 1; 1 where there is nothing to go and to turn
  bool is_too_deep() const;
  // Seen to leave in this tick, having gone more than a radius, before the end.
  bool slipped() const { return slipped_; }
  // (3) m, in W: where the touch point is to be next.
  Vec3 place_W() const;

  // Who has left a line is back within this share of the radius: at the rim itself a hand's tremor would be a
  // slip each time.
  static constexpr double kBack = 0.8;

private:
  // The nearest place of the line from where it has been followed to, to a diameter farther: whoever cuts a
  // corner by less is within the radius of the line.
  struct Nearest {
    double along = 0;     // m
    double distance = 0;  // m
  };
  Nearest nearest(const Vec3& p_WC) const;
  Vec3 at(double along) const;
  double depth_of(const Vec3& p_WC) const;
  bool is_in_bore(const Vec3& p_WC) const;

  Checkpoint checkpoint_;
  std::vector<Vec3> corners_;  // (n + 1) m, of the line; empty: there is none
  double length_ = 0;          // m, of the line
  bool inside_ = false, slipped_ = false, paused_ = false;
  double along_ = 0;          // m, of the line
  double depth_ = 0;          // m, in the bore
  double angle_ = 0;          // rad, turned so far
  std::optional<Quat> q_WT_;  // a tick ago, where that counts
};

}  // namespace fulcrum::scenario
