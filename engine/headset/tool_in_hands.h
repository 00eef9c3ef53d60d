#pragma once
// What hands do in a headset, picture by picture: they take the tool, and what they press stands for Esc and
// Enter.

#include <array>
#include <optional>

#include "drivers/controller/controllers.h"
#include "engine/app/run/button_commands.h"
#include "engine/headset/placement.h"
#include "engine/input/grasp.h"
#include "engine/xr/hands.h"

namespace fulcrum::headset {

class ToolInHands {
public:
  // X_WH: where the handle is until a hand takes it.
  explicit ToolInHands(const Pose& X_WH) : grasp_(X_WH), wanted_{X_WH} {}

  // One picture. seen: the scene is; rests: nobody can move the tool. What was asked for: a squeeze that
  // began, or went on, while nobody saw the scene or nobody said whether the hand squeezes, asks for nothing,
  // and has to end first.
  std::optional<Command> follow(const std::array<xr::Hand, xr::kHands>& hands, const Placement& placement,
                                bool seen, bool rests);

  const WantedHandle& wanted() const { return wanted_; }
  // Whoever holds the tool takes it anew, from where both are then.
  void let_go() { grasp_.let_go(); }
  bool is_hand_in_sight() const { return in_sight_; }

private:
  // Of each hand, left and right: what stands for Esc, and for Enter.
  static constexpr std::array<std::uint32_t, xr::kHands> kStops{1, 2}, kHolds{4, 8};

  input::Grasp grasp_;
  WantedHandle wanted_;
  std::uint32_t to_end_ = 0;  // of kHolds
  app::ButtonCommands buttons_{kStops[0] | kStops[1], kHolds[0] | kHolds[1]};
  bool in_sight_ = false;  // one hand at least, in the newest picture
};

}  // namespace fulcrum::headset
