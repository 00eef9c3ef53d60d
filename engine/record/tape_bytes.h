#pragma once
// Numbers in a tape: little-endian, doubles bit for bit.

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "engine/record/crc32c.h"

namespace fulcrum::record {

inline constexpr std::uint32_t kTickChunk = 0x4b434954;  // "TICK" in the file
inline constexpr std::uint32_t kEndChunk = 0x20444e45;   // "END "

template <std::unsigned_integral T>
void put(std::string& to, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    to += static_cast<char>((std::uint64_t{value} >> (8 * i)) & 0xff);
}

inline void put(std::string& to, double value) {
  put(to, std::bit_cast<std::uint64_t>(value));
}

// The checksum of to[from] up to its end, appended.
inline void put_crc(std::string& to, std::size_t from) {
  put(to, crc32c(std::as_bytes(std::span(to).subspan(from))));
}

// Reads past the end give zero and leave ok() false.
class ByteReader {
public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <std::unsigned_integral T>
  T get() {
    const std::span<const std::byte> bytes = take(sizeof(T));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      value |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    return static_cast<T>(value);
  }
  double get_double() { return std::bit_cast<double>(get<std::uint64_t>()); }

  // n bytes, or none if there are fewer.
  std::span<const std::byte> take(std::size_t n) {
    if (n > left()) {
      ok_ = false;
      return {};
    }
    offset_ += n;
    return bytes_.subspan(offset_ - n, n);
  }

  std::size_t offset() const { return offset_; }
  std::size_t left() const { return bytes_.size() - offset_; }
  bool ok() const { return ok_; }

private:
  std::span<const std::byte> bytes_;
  std::size_t offset_ = 0;
  bool ok_ = true;
};

}  // namespace fulcrum::record
