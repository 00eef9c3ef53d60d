#pragma once
// What `fulcrum doctor` makes of the devices that a hand could hold.

#include <vector>

#include "drivers/registry.h"
#include "engine/app/doctor/finding.h"

namespace fulcrum::app {

// best: the one of them that a run takes.
Finding devices_in(const std::vector<DeviceListing>& devices, const DeviceListing& best);

}  // namespace fulcrum::app
