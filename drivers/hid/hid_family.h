#pragma once
// HID devices that speak the same, wherever one of them is plugged in.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "drivers/hid/hid_link.h"
#include "drivers/hid/hid_port.h"
#include "drivers/hid/hid_protocol.h"
#include "drivers/own_device.h"
#include "haptics/device/vibrotactile_desc.h"
#include "haptics/math/result.h"

namespace fulcrum::hid {

struct HidFamily {
  std::span<const HidId> (*ids)();
  // Of those that are pushed. signal: what their channels are to render.
  std::unique_ptr<HidProtocol> (*protocol)(const HidPlace&, const VibrotactileSignal& signal) = nullptr;
  Nodes nodes = Nodes::of_axes;
  std::string_view product{};  // what it calls itself, where its numbers may be others', too
};

// One of them; one that may not be opened only if there is no other.
std::optional<HidPlace> find_one(const HidFamily& family);
// Where it is, or why it cannot be opened, with what would cure it.
Result<HidPlace> place_of(const HidFamily& family);
// own: which of them it is to be; the one that is opened where the run has none yet.
Result<std::unique_ptr<HidPort>> open_one(const HidFamily& family, OwnDevice& own);
// With what it speaks.
Result<HidOpened> open_spoken(const HidFamily& family, const VibrotactileSignal& signal, OwnDevice& own);

}  // namespace fulcrum::hid
