// Reference: none; any bytes as a bake, the first of which says of what kind. Invariants: reading it neither
// crashes nor goes out of bounds, and what is accepted can be written again, to the same bytes.

#include <cstdint>
#include <cstdlib>
#include <ranges>

#include "engine/assets/baked_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulcrum;
  if (size == 0) return 0;
  const auto bytes = std::as_bytes(std::span(data + 1, size - 1));
  if (data[0] % 2 == 0) {
    const auto field = field_from_bytes(bytes);
    if (field && !std::ranges::equal(to_bytes(*field), bytes)) std::abort();
    if (field) (void)field->distance(Vec3(1e-3, 2e-3, -3e-3));
  } else {
    const auto shell = pointshell_from_bytes(bytes);
    if (shell && !std::ranges::equal(to_bytes(*shell), bytes)) std::abort();
  }
  return 0;
}
