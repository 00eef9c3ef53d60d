#pragma once
// SHA-256 (FIPS 180-4): names content by what it is.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/files/regular_file.h"
#include "haptics/math/result.h"

namespace fulcrum {

class Sha256 {
public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void update(std::span<const std::byte> bytes);
  void update(std::string_view text) { update(std::as_bytes(std::span(text))); }
  std::string finish_hex();  // 64 lower-case digits; starts over afterwards

private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string sha256_hex(std::span<const std::byte> bytes);
Result<std::string> sha256_hex(RegularFile file);

}  // namespace fulcrum
