// Damaged files. Invariants, of every mutant: parse_glb() returns (no crash, no exception, nothing out of
// bounds when run under the address sanitizer); a refusal is a sentence that names the file; an accepted
// model is sound: indices within range, as many normals as positions, all numbers finite.

#include <gtest/gtest.h>

#include <random>

#include "engine/assets/gltf.h"
#include "engine/assets/image.h"
#include "tests/assets/textured.h"

namespace fulcrum {
namespace {

void expect_sound_or_refused(std::span<const std::byte> bytes) {
  const auto model = parse_glb(bytes, "mutant.glb");
  if (!model) {
    const std::string& sentence = model.error().sentence;
    ASSERT_TRUE(sentence.starts_with("mutant.glb: ") && sentence.ends_with(".")) << sentence;
    return;
  }
  ASSERT_FALSE(model->materials.empty());
  for (const ModelPart& part : model->parts) {
    ASSERT_LT(part.material, model->materials.size());
    ASSERT_EQ(part.positions.size(), part.normals.size());
    ASSERT_EQ(part.indices.size() % 3, 0u);
    for (const std::uint32_t i : part.indices) ASSERT_LT(i, part.positions.size());
    for (const Vec3& p : part.positions) ASSERT_TRUE(p.allFinite());
    for (const Vec3& n : part.normals) ASSERT_TRUE(n.allFinite());
    ASSERT_TRUE(part.uv.empty() || part.uv.size() == part.positions.size());
  }
  for (const ModelLight& light : model->lights) {
    ASSERT_TRUE(light.position_M.allFinite() && light.intensity >= 0 && light.range.value_or(1) > 0);
    ASSERT_NEAR(light.direction_M.norm(), 1, 1e-9);
    ASSERT_LE(light.inner_cone, light.outer_cone);
  }
  for (const ModelMaterial& material : model->materials) {
    if (!material.detail) continue;
    const MaterialDetail& detail = *material.detail;
    for (const auto& use : {detail.base_colour, detail.normal})
      if (use) ASSERT_LT(use->image, model->images.size());
  }
  for (const ModelImage& image : model->images)
    if (const auto decoded = decode_image(image.encoded))
      ASSERT_EQ(decoded->rgba.size(), std::size_t{4} * decoded->width * decoded->height);
}

class Mutator {
public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::vector<std::byte> mutate(std::vector<std::byte> bytes) {
    for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
      switch (below(6)) {
        case 0:  // one byte
          bytes[below(bytes.size())] = static_cast<std::byte>(below(256));
          break;
        case 1:  // one bit
          bytes[below(bytes.size())] ^= static_cast<std::byte>(1u << below(8));
          break;
        case 2:  // an extreme word
          overwrite(bytes, kWords[below(std::size(kWords))]);
          break;
        case 3:  // a digit of the description
          change_digit(bytes);
          break;
        case 4:  // the end is missing
          bytes.resize(std::max<std::size_t>(1, bytes.size() - below(64)));
          break;
        default:  // something twice
          bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size())),
                       bytes[below(bytes.size())]);
          break;
      }
    }
    return bytes;
  }

private:
  static constexpr std::uint32_t kWords[] = {0u,          1u,          0x7fffffffu, 0x80000000u,
                                             0xffffffffu, 0x7fc00000u, 0x7f800000u};

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  void overwrite(std::vector<std::byte>& bytes, std::uint32_t word) {
    if (bytes.size() < 4) return;
    std::memcpy(bytes.data() + below(bytes.size() - 3), &word, 4);
  }

  void change_digit(std::vector<std::byte>& bytes) {
    const std::size_t start = below(bytes.size());
    for (std::size_t i = start; i < bytes.size(); ++i) {
      if (bytes[i] < std::byte{'0'} || bytes[i] > std::byte{'9'}) continue;
      bytes[i] = below(4) == 0 ? std::byte{'-'} : static_cast<std::byte>('0' + below(10));
      return;
    }
  }

  std::mt19937_64 random_;
};

TEST(GltfFuzz, DamagedFilesAreRefusedOrSound) {
  const std::string material =
      R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":0,"scale":2},)"
      R"("extensions":{"KHR_materials_sheen":{"sheenColorFactor":[1,1,1]}}})";
  glb::Tetrahedron lit;
  lit.more = R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":20,"range":3.5},)"
             R"({"type":"spot","spot":{"innerConeAngle":0.2,"outerConeAngle":0.6}}]}},)";
  lit.nodes = R"([{"mesh":0},{"rotation":[0,0.6,0,0.8],"extensions":{"KHR_lights_punctual":{"light":0}}},)"
              R"({"translation":[0,1,5],"extensions":{"KHR_lights_punctual":{"light":1}}}])";
  lit.scene = "";
  Mutator mutator(20260101);
  for (const std::vector<std::byte>& whole :
       {glb::Tetrahedron().bytes(), test::Textured(material).file.bytes(), lit.bytes()}) {
    int accepted = 0;
    for (int i = 0; i < 20000; ++i) {
      const std::vector<std::byte> mutant = mutator.mutate(whole);
      expect_sound_or_refused(mutant);
      if (HasFatalFailure()) return;
      accepted += parse_glb(mutant, "mutant.glb") ? 1 : 0;
    }
    EXPECT_GT(accepted, 200);  // some damage is harmless: the mutants get past the parser
  }
}

TEST(GltfFuzz, EveryTruncationIsRefused) {
  const std::vector<std::byte> whole = glb::Tetrahedron().bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    expect_sound_or_refused(std::span(whole).first(size));
    EXPECT_FALSE(parse_glb(std::span(whole).first(size), "mutant.glb"));
  }
}

}  // namespace
}  // namespace fulcrum
