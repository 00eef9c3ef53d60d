#include "drivers/falcon/falcon_packets.h"

#include <algorithm>

namespace fulcrum::falcon {
namespace {

constexpr std::uint8_t kBegin = '<', kEnd = '>', kZero = 'A';
constexpr std::size_t kStatus = 13, kSpare = 14;
constexpr unsigned kAllHomed = 7;  // a bit for each leg, above the buttons'

}  // namespace

std::optional<FalconSays> decode(std::span<const std::uint8_t> packet) noexcept {
  if (packet.size() != kPacketBytes || packet.front() != kBegin || packet.back() != kEnd) return std::nullopt;
  FalconSays says;
  for (std::size_t leg = 0; leg < says.counts.size(); ++leg) {
    unsigned word = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const unsigned nibble = static_cast<unsigned>(packet[1 + 4 * leg + i]) - kZero;
      if (nibble > 15) return std::nullopt;
      word |= nibble << 4 * i;
    }
    says.counts[leg] = static_cast<std::int16_t>(static_cast<std::uint16_t>(word));
  }
  const unsigned status = static_cast<unsigned>(packet[kStatus]) - kZero;
  if (status > 0x7f) return std::nullopt;
  says.buttons = status & 15;
  says.homed = status >> 4 == kAllHomed;
  return says;
}

Packet encode(const std::array<int, 3>& motors, unsigned lights) noexcept {
  Packet packet{};
  packet.fill(kZero);
  packet.front() = kBegin;
  packet.back() = kEnd;
  for (std::size_t leg = 0; leg < motors.size(); ++leg) {
    const auto word = static_cast<unsigned>(std::clamp(motors[leg], -kMostMotor, kMostMotor)) & 0xffffu;
    for (std::size_t i = 0; i < 4; ++i)
      packet[1 + 4 * leg + i] = static_cast<std::uint8_t>(kZero + (word >> 4 * i & 15));
  }
  packet[kStatus] = static_cast<std::uint8_t>(kZero + (lights & 15));
  return packet;
}

// No letter of a number is a '<', so that one begins a packet wherever it stands; what the spare byte may be
// is not known.
std::optional<FalconSays> PacketStream::feed(std::span<const std::uint8_t> bytes) noexcept {
  std::optional<FalconSays> newest;
  for (const std::uint8_t byte : bytes) {
    if (byte == kBegin && length_ != kSpare) length_ = 0;
    if (length_ == 0 && byte != kBegin) continue;
    packet_[length_++] = byte;
    if (length_ < kPacketBytes) continue;
    length_ = 0;
    if (const auto says = decode(packet_)) newest = says;
  }
  return newest;
}

}  // namespace fulcrum::falcon
