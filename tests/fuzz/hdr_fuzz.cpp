// Reference: none; any bytes as a Radiance picture. Invariants: reading it neither crashes nor goes out of
// bounds; a refusal is a clause; a picture that is accepted is twice as wide as high, has as many pixels as
// that, and in each of them light that is a number from 0 to the brightest there may be.

#include <cstdint>
#include <cstdlib>

#include "engine/assets/hdr.h"

namespace {

void expect(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto picture = fulcrum::decode_hdr({data, size});
  if (!picture) {
    expect(!picture.error().sentence.empty() && !picture.error().sentence.ends_with("."));
    return 0;
  }
  expect(picture->width == 2 * picture->height && picture->width <= fulcrum::kWidestHdr);
  expect(picture->pixels.size() == std::size_t{picture->width} * picture->height);
  for (const auto& pixel : picture->pixels)
    for (const float part : pixel) expect(part >= 0.0F && part <= fulcrum::kBrightestHdr);
  return 0;
}
