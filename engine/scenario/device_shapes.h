#pragma once
// The arms of a device as models, made from its table: bars between joints, drums about their axes.
//
// What is between the joints is a likeness; where the joints and the ends are is the table's. Of two arms
// each comes to the handle from behind, along it: a last link that went straight to its end would go through
// whatever the tool's tip touches.

#include <optional>

#include "engine/render/visual_desc.h"
#include "haptics/device/mapping.h"
#include "haptics/device/mechanism_desc.h"

namespace fulcrum::scenario {

// Appends base and links. A link's instances follow body 1, 2, ..., in the order of DeviceLinks::follow(), in
// its frames L. floor: m, y in W of what the base stands on; none: it stands on nothing.
void add_device_arms(render::VisualDesc& desc, const MechanismDesc& mechanism, const MappingDesc& mapping,
                     std::optional<double> floor, std::uint32_t layers);

}  // namespace fulcrum::scenario
