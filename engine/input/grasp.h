#pragma once
// How hands take a handle that they see: it goes with the one that holds it, from where it is, and stays
// where it is left. A hand that is lost from sight, or a space that moves, so never makes it jump.

#include <array>
#include <cstddef>
#include <optional>

#include "haptics/math/pose.h"

namespace fulcrum::input {

struct GraspingHand {
  std::optional<Pose> X_WG;  // of the grip; none: nobody knows where it is
  bool holds = false;
};

class Grasp {
public:
  explicit Grasp(const Pose& X_WH) : X_WH_(X_WH) {}

  // Where the handle is now. The first of the hands that holds keeps it until it lets go. rests: nobody can
  // move it.
  const Pose& follow(const std::array<GraspingHand, 2>& hands, bool rests);
  // Whoever holds it takes it anew, from where both are then; who held it is not missed.
  void let_go() {
    hand_.reset();
    lost_.reset();
  }
  // The hand that held it went out of sight, and neither is back nor has another one taken its place.
  bool is_lost() const { return lost_.has_value(); }

private:
  Pose X_WH_;
  std::optional<std::size_t> hand_, lost_;  // that holds it; that held it when it went out of sight
  Pose X_WG_;                               // of that hand when it was seen last
};

}  // namespace fulcrum::input
