#include "engine/input/grasp.h"

namespace fulcrum::input {

const Pose& Grasp::follow(const std::array<GraspingHand, 2>& hands, bool rests) {
  const auto can_hold = [&](const GraspingHand& hand) { return !rests && hand.holds && hand.X_WG; };
  if (lost_) {
    const GraspingHand& other = hands[1 - *lost_];
    if (hands[*lost_].X_WG || (other.X_WG && other.holds)) lost_.reset();
  }
  if (hand_ && !hands[*hand_].X_WG) lost_ = hand_;
  if (hand_ && !can_hold(hands[*hand_])) hand_.reset();
  if (hand_) {
    // About itself: a turn of the hand that holds it from afar does not swing it around.
    const Pose& X_WG = *hands[*hand_].X_WG;
    X_WH_.p += X_WG.p - X_WG_.p;
    X_WH_.q = (X_WG.q * X_WG_.q.conjugate() * X_WH_.q).normalized();
    X_WG_ = X_WG;
    return X_WH_;
  }
  for (std::size_t i = 0; i < hands.size() && !hand_; ++i) {
    if (!can_hold(hands[i])) continue;
    hand_ = i;
    X_WG_ = *hands[i].X_WG;
  }
  return X_WH_;
}

}  // namespace fulcrum::input
