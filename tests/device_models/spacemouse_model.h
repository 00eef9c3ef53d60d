#pragma once
// A 3Dconnexion SpaceMouse Compact. While its cap is pushed or turned it says so in turn, in two reports; let
// go, it says that once, and is silent.

#include <array>

#include "tests/device_models/hid_model.h"

namespace fulcrum::test {

class SpaceMouseModel final : public HidModel {
public:
  static constexpr int kFull = 350;  // of a reading, the cap at its stop
  SpaceMouseModel();

  // X to the right, Y toward the person, Z down; then the turns about them.
  void push(const std::array<int, 6>& readings);
  // A bit for each.
  void press(std::uint16_t buttons);

  std::optional<Bytes> say() override;
  void begin() override;

private:
  std::array<int, 6> readings_{};
  std::uint16_t buttons_ = 0, buttons_said_ = 0;
  std::array<bool, 2> at_rest_{true, true};  // has been said of way and turn
  std::size_t next_ = 0;                     // of the two
};

}  // namespace fulcrum::test
