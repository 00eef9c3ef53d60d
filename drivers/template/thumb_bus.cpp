#include "drivers/template/thumb_bus.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::thumb {
namespace {

constexpr double kUnit = 1e-5;    // m
constexpr int kWait_ms = 5;       // for a report; it sends a thousand a second
constexpr int kMostWaiting = 64;  // reports; hidraw keeps 63 and drops what is newer

}  // namespace

std::optional<Says> decode(hid::Bytes report) {
  if (report.size() != 7) return std::nullopt;
  const auto axis = [report](std::size_t at) { return kUnit * hid::i16_at(report, at); };
  return Says{{axis(0), axis(2), axis(4)}, report[6]};
}

std::array<std::uint8_t, 7> encode(const Vec3& force_D) {
  std::array<std::uint8_t, 7> bytes{};
  if (!force_D.allFinite()) return bytes;
  for (std::size_t i = 0; i < 3; ++i) {
    const double mN = std::clamp(1e3 * force_D.data()[i], -32767.0, 32767.0);
    const auto word = static_cast<std::uint16_t>(std::lround(mN));
    bytes[1 + 2 * i] = static_cast<std::uint8_t>(word & 0xffu);
    bytes[2 + 2 * i] = static_cast<std::uint8_t>(word >> 8);
  }
  return bytes;
}

// What cannot be told to rest is not to be pushed with. What waits is read to its end, so that the sample is
// the newest.
ForceBus::Turn ThumbBus::exchange(const DeviceCommand& command, DeviceSample& sample) {
  if (!port_->write(encode(command.F_H_D.force))) return Turn::lost;
  std::array<std::uint8_t, 64> bytes{};
  std::optional<Says> says;
  for (int count = 0, wait = kWait_ms; count < kMostWaiting; ++count, wait = 0) {
    const int length = port_->read(bytes, wait);
    if (length < 0) return Turn::lost;
    if (length == 0) break;
    if (const auto next = decode(std::span(bytes).first(static_cast<std::size_t>(length)))) says = next;
  }
  if (!says) return Turn::none;
  sample.X_DH.p = says->p_DH;
  sample.buttons = says->buttons;
  sample.age = 0;
  return Turn::fresh;
}

}  // namespace fulcrum::thumb
