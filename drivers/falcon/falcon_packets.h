#pragma once
// What a Falcon's firmware says and is told, as bytes: packets of 16 either way, each number in four letters
// from 'A' on, the low nibble first. Source: libnifalcon, FalconFirmwareNovintSDK.cpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace fulcrum::falcon {

inline constexpr std::size_t kPacketBytes = 16;
using Packet = std::array<std::uint8_t, kPacketBytes>;

inline constexpr int kMostMotor = 4096;  // of a motor's value, either way

// Of the ring around the grip; the first one asks the firmware to look for the legs' index marks.
inline constexpr unsigned kHoming = 1, kGreen = 2, kBlue = 4, kRed = 8;

struct FalconSays {
  std::array<int, 3> counts{};  // of the legs' encoders
  unsigned buttons = 0;         // bit n: button n of the grip is down
  bool homed = false;           // all legs have passed their index marks: the counts are angles
};
// None: it is not such a packet.
std::optional<FalconSays> decode(std::span<const std::uint8_t> packet) noexcept;

// motors: each is held within kMostMotor.
Packet encode(const std::array<int, 3>& motors, unsigned lights) noexcept;

// Packets out of bytes that come in pieces of any length.
class PacketStream {
public:
  // The newest packet that these bytes end; none: they end none that is one.
  std::optional<FalconSays> feed(std::span<const std::uint8_t> bytes) noexcept;
  void clear() noexcept { length_ = 0; }

private:
  Packet packet_{};
  std::size_t length_ = 0;  // bytes of it that have come
};

}  // namespace fulcrum::falcon
