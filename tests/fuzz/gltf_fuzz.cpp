// Reference: none; any text as a model's description, and any bytes as what follows it. Invariants: reading
// it neither crashes nor goes out of bounds; a refusal is a sentence that names the file; a model that is
// accepted is sound: indices within range, as many normals as positions, all numbers finite, lights with a
// direction; its pictures are decoded, to as many pixels as they say, or refused.
//
// The input is the JSON, up to the first zero byte, and the binary chunk after it: the header and the lengths
// of a .glb are made to fit, so that the damage gets behind them. One that begins with "glTF" is taken as it
// is.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "engine/assets/gltf.h"
#include "engine/assets/image.h"
#include "tests/assets/glb_builder.h"

namespace {

using namespace fulcrum;

void expect(bool holds) {
  if (!holds) std::abort();
}

std::vector<std::byte> glb_of(std::string_view input) {
  if (input.starts_with("glTF")) {
    const auto bytes = std::as_bytes(std::span(input));
    return {bytes.begin(), bytes.end()};
  }
  const std::size_t end = std::min(input.find('\0'), input.size());
  const auto rest = std::as_bytes(std::span(input.substr(std::min(end + 1, input.size()))));
  return glb::file(std::string(input.substr(0, end)), {rest.begin(), rest.end()});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto model = parse_glb(glb_of({reinterpret_cast<const char*>(data), size}), "mutant.glb");
  if (!model) {
    const std::string& sentence = model.error().sentence;
    expect(sentence.starts_with("mutant.glb: ") && sentence.ends_with("."));
    return 0;
  }
  expect(!model->materials.empty() && !model->parts.empty());
  for (const ModelPart& part : model->parts) {
    expect(part.material < model->materials.size());
    expect(part.positions.size() == part.normals.size());
    expect(part.indices.size() % 3 == 0);
    for (const std::uint32_t i : part.indices) expect(i < part.positions.size());
    for (const Vec3& p : part.positions) expect(p.allFinite());
    for (const Vec3& n : part.normals) expect(n.allFinite());
    expect(part.uv.empty() || part.uv.size() == part.positions.size());
  }
  for (const ModelLight& light : model->lights) {
    expect(light.position_M.allFinite() && std::abs(light.direction_M.norm() - 1) < 1e-9);
    expect(std::isfinite(light.intensity) && light.intensity >= 0 && light.range.value_or(1) > 0);
    expect(light.inner_cone <= light.outer_cone);
  }
  for (const ModelMaterial& material : model->materials)
    if (material.detail && material.detail->base_colour)
      expect(material.detail->base_colour->image < model->images.size());
  for (const ModelImage& image : model->images)
    if (const auto decoded = decode_image(image.encoded))
      expect(decoded->rgba.size() == std::size_t{4} * decoded->width * decoded->height);
  return 0;
}
