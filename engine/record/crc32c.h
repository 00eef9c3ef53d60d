#pragma once
// CRC-32C (Castagnoli): tells damage from data.

#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum::record {

std::uint32_t crc32c(std::span<const std::byte> bytes);

}  // namespace fulcrum::record
