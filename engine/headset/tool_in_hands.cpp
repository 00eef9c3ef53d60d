#include "engine/headset/tool_in_hands.h"

namespace fulcrum::headset {

std::optional<Command> ToolInHands::follow(const std::array<xr::Hand, xr::kHands>& hands,
                                           const Placement& placement, bool seen, bool rests) {
  std::array<input::GraspingHand, xr::kHands> grasping;
  std::uint32_t down = 0, untold = seen ? 0 : kHolds[0] | kHolds[1];
  in_sight_ = false;
  for (std::size_t i = 0; i < hands.size(); ++i) {
    if (hands[i].X_LG) grasping[i].X_WG = placement.in_world(*hands[i].X_LG);
    grasping[i].holds = hands[i].holds;
    in_sight_ = in_sight_ || hands[i].X_LG;
    down |= (hands[i].holds ? kHolds[i] : 0U) | (hands[i].stops ? kStops[i] : 0U);
    if (!hands[i].is_known) untold |= kHolds[i];
  }
  wanted_.X_DH = grasp_.follow(grasping, rests);
  wanted_.seen = !grasp_.is_lost();
  to_end_ = untold | (to_end_ & down);
  return buttons_.pressed(down & ~to_end_);
}

}  // namespace fulcrum::headset
