#include "drivers/spacemouse/spacemouse_protocol.h"

#include <algorithm>

#include "drivers/hid/hid_bytes.h"

namespace fulcrum {
namespace {

// Three readings from `at` on, from the device's axes into right, up, toward the person.
Vec3 read_axes(std::span<const std::uint8_t> report, std::size_t at) {
  const auto reading = [&](std::size_t i) {
    const double part = hid::i16_at(report, at + 2 * i) / SpaceMouseProtocol::kFull;
    return std::clamp(part, -1.0, 1.0);
  };
  return {reading(0), -reading(2), reading(1)};
}

}  // namespace

bool SpaceMouseProtocol::decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept {
  if (report.empty()) return false;
  switch (report[0]) {
    case 1:
      if (report.size() < 7) return false;
      axes.way = read_axes(report, 1);
      if (report.size() >= 13) axes.turn = read_axes(report, 7);
      return true;
    case 2:
      if (report.size() < 7) return false;
      axes.turn = read_axes(report, 1);
      return true;
    case 3:
      if (report.size() < 3) return false;
      axes.buttons = report.size() >= 5 ? hid::u32_at(report, 1) : hid::u16_at(report, 1);
      return true;
    default:
      return false;
  }
}

std::span<const hid::HidId> spacemouse_ids() {
  static constexpr hid::HidId ids[] = {
      {0x046d, 0xc603}, {0x046d, 0xc605}, {0x046d, 0xc606}, {0x046d, 0xc621}, {0x046d, 0xc623},
      {0x046d, 0xc625}, {0x046d, 0xc626}, {0x046d, 0xc627}, {0x046d, 0xc628}, {0x046d, 0xc629},
      {0x046d, 0xc62b}, {0x256f, 0xc62c}, {0x256f, 0xc62e}, {0x256f, 0xc62f}, {0x256f, 0xc631},
      {0x256f, 0xc632}, {0x256f, 0xc633}, {0x256f, 0xc635}, {0x256f, 0xc636}, {0x256f, 0xc638},
      {0x256f, 0xc63a}, {0x256f, 0xc652},
  };
  return ids;
}

}  // namespace fulcrum
