#pragma once
// A 3Dconnexion SpaceMouse: a cap that is pushed and turned in six axes. Facts of the reports from spacenavd
// (dev.c) and PySpaceMouse (devices.toml).
//
//     1: X Y Z, int16 each, +-350; in newer ones Rx Ry Rz follow, 13 bytes in all
//     2: Rx Ry Rz, where they come by themselves
//     3: buttons, a bit each
//
// X is to the right, Y toward the person, Z down. It says nothing while the cap is let go; it says so once.

#include <cstdint>
#include <span>

#include "drivers/hid/hid_id.h"
#include "drivers/hid/hid_protocol.h"

namespace fulcrum {

class SpaceMouseProtocol final : public hid::HidProtocol {
public:
  static constexpr double kFull = 350;  // of a reading, the cap at its stop

  bool decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept override;
  bool streams() const noexcept override { return false; }
};

// 3Dconnexion's mice (CadMouse) have no cap, and are not among them.
std::span<const hid::HidId> spacemouse_ids();

}  // namespace fulcrum
