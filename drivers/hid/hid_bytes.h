#pragma once
// Numbers in reports: little-endian, whatever the machine.

#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum::hid {

using Bytes = std::span<const std::uint8_t>;

inline std::uint16_t u16_at(Bytes report, std::size_t at) {
  return static_cast<std::uint16_t>(report[at] | report[at + 1] << 8);
}
inline std::int16_t i16_at(Bytes report, std::size_t at) {
  return static_cast<std::int16_t>(u16_at(report, at));
}
inline std::uint32_t u32_at(Bytes report, std::size_t at) {
  return u16_at(report, at) | static_cast<std::uint32_t>(u16_at(report, at + 2)) << 16;
}
inline void put_u32(std::span<std::uint8_t> report, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) report[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
}

// CRC-32 (IEEE 802.3, reflected) of a seed byte and what follows it: what Sony's pads end a Bluetooth report
// with.
std::uint32_t crc32(std::uint8_t seed, Bytes bytes);

}  // namespace fulcrum::hid
