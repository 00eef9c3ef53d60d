#include "drivers/hid/hid_bytes.h"

namespace fulcrum::hid {
namespace {

constexpr std::uint32_t kPolynomial = 0xEDB88320;

std::uint32_t fed(std::uint32_t crc, std::uint8_t byte) {
  crc ^= byte;
  for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? kPolynomial : 0);
  return crc;
}

}  // namespace

std::uint32_t crc32(std::uint8_t seed, Bytes bytes) {
  std::uint32_t crc = fed(~0U, seed);
  for (const std::uint8_t byte : bytes) crc = fed(crc, byte);
  return ~crc;
}

}  // namespace fulcrum::hid
