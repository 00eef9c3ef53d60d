#pragma once
// Makes the checksums of a damaged tape fit, so that what reads it gets past them to the damage.

#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "engine/record/crc32c.h"

namespace fulcrum::record {

// The checksum that follows text[at, at + size). False: there is no room for one.
inline bool mend_checksum(std::string& text, std::size_t at, std::size_t size) {
  if (at > text.size() || size > text.size() - at || text.size() - at - size < 4) return false;
  const std::uint32_t crc = crc32c(std::as_bytes(std::span(text).subspan(at, size)));
  std::memcpy(text.data() + at + size, &crc, sizeof crc);
  return true;
}

// All of them: of the magic and the header's size, of the header, and of each block's size and bytes.
inline void mend_checksums(std::string& text) {
  const auto size_at = [&text](std::size_t at) {
    std::uint32_t size = 0;
    std::memcpy(&size, text.data() + at, sizeof size);
    return size;
  };
  if (!mend_checksum(text, 0, 16)) return;
  std::size_t at = 20;
  std::size_t size = size_at(12);
  while (mend_checksum(text, at, size)) {
    at += size + 4;
    if (!mend_checksum(text, at, 8)) return;
    size = size_at(at + 4);
    at += 12;
  }
}

}  // namespace fulcrum::record
