#pragma once
// A sound card that is known by its USB numbers.

#include <filesystem>
#include <optional>
#include <span>

#include "drivers/hid/hid_id.h"

namespace fulcrum::sound {

// The number of the first card that is one of `ids`. asound: where the kernel tells of its cards,
// /proc/asound.
std::optional<int> find_usb_card(const std::filesystem::path& asound, std::span<const hid::HidId> ids);

}  // namespace fulcrum::sound
