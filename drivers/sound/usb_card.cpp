#include "drivers/sound/usb_card.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

namespace fulcrum::sound {
namespace {

constexpr int kMostCards = 32;  // of the kernel

std::optional<hid::HidId> usb_numbers(const std::filesystem::path& file) {
  std::string text;
  std::ifstream in(file);
  unsigned vendor = 0, product = 0;
  if (!std::getline(in, text) || std::sscanf(text.c_str(), "%4x:%4x", &vendor, &product) != 2)
    return std::nullopt;
  return hid::HidId{static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product)};
}

}  // namespace

std::optional<int> find_usb_card(const std::filesystem::path& asound, std::span<const hid::HidId> ids) {
  for (int card = 0; card < kMostCards; ++card) {
    const auto numbers = usb_numbers(asound / ("card" + std::to_string(card)) / "usbid");
    if (numbers && std::ranges::find(ids, *numbers) != ids.end()) return card;
  }
  return std::nullopt;
}

}  // namespace fulcrum::sound
