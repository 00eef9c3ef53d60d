// Each feature of glTF that docs/looks.md says is drawn, from a file to the picture: a ball that has it, and
// that it makes a difference.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <glm/ext/matrix_clip_space.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/look.h"
#include "engine/render/plan.h"
#include "image_compare.h"
#include "lit_scene.h"
#include "surface_balls.h"
#include "tests/assets/pictures.h"

namespace fulcrum::render {
namespace {

// Members of a material; what has the feature, and what is the same without it.
struct Feature {
  const char* name;
  std::string with, without;
};

std::string body(const std::string& colour, const std::string& roughness, const std::string& more = "",
                 const std::string& metallic = "0") {
  return R"("pbrMetallicRoughness":{"baseColorFactor":[)" + colour + R"(],"metallicFactor":)" + metallic +
         R"(,"roughnessFactor":)" + roughness + more + "}";
}

std::string extension(const std::string& name, const std::string& members = "") {
  return R"("KHR_materials_)" + name + R"(":{)" + members + "}";
}

std::string with_extensions(const std::string& of, const std::string& extensions) {
  return of + R"(,"extensions":{)" + extensions + "}";
}

constexpr const char* kGrey = "0.5,0.5,0.5,1";
constexpr const char* kWhite = "1,1,1,1";

// Of the pictures, in their order: checks (PNG), checks (JPEG), metal-rough, normal, occlusion, emissive,
// holes; and the first one again, clamped and with its pixels seen.
std::vector<Feature> features() {
  const std::string white = body(kWhite, "0.5"), grey = body(kGrey, "0.5"),
                    smooth = body("0.1,0.1,0.1,1", "0.15"), glass = body("0.9,1,0.9,1", "0.05"),
                    dark = body("0.05,0.05,0.05,1", "0.5"), red = body("0.4,0.02,0.02,1", "0.8"),
                    cloth = body("0.05,0.05,0.2,1", "1");
  const auto textured = [](const std::string& index, const std::string& more = "") {
    return body(kWhite, "0.5", R"(,"baseColorTexture":{"index":)" + index + more + "}");
  };
  const std::string gold = "0.9,0.7,0.4,1", glow = dark + R"(,"emissiveFactor":[0.8,0.4,0.1])",
                    clear = extension("transmission", R"("transmissionFactor":1)");
  return {
      {"base colour, PNG", textured("0"), white},
      {"base colour, JPEG", textured("1"), white},
      {"metallic and roughness", body(gold, "1", R"(,"metallicRoughnessTexture":{"index":2})", "1"),
       body(gold, "1", "", "1")},
      {"normal", grey + R"(,"normalTexture":{"index":3})", grey},
      {"occlusion", grey + R"(,"occlusionTexture":{"index":4})", grey},
      {"emissive", glow + R"(,"emissiveTexture":{"index":5})", glow},
      {"emissive_strength", with_extensions(glow, extension("emissive_strength", R"("emissiveStrength":4)")),
       glow},
      {"mask", textured("6") + R"(,"alphaMode":"MASK","doubleSided":true)", textured("6")},
      {"blend", body("0.1,0.4,0.9,0.5", "0.2") + R"(,"alphaMode":"BLEND")", body("0.1,0.4,0.9,0.5", "0.2")},
      {"double sided", grey + R"(,"doubleSided":true)", grey},
      {"texture_transform",
       textured("0", R"(,"extensions":{"KHR_texture_transform":{"offset":[0.2,0.1],"rotation":0.6,)"
                     R"("scale":[0.5,1.5]}})"),
       textured("0")},
      {"second coordinates", textured("0", R"(,"texCoord":1)"), textured("0")},
      {"clamped, nearest", textured("7"), textured("0")},
      {"clearcoat", with_extensions(red, extension("clearcoat", R"("clearcoatFactor":1)")), red},
      {"sheen",
       with_extensions(cloth,
                       extension("sheen", R"("sheenColorFactor":[0.6,0.6,1],"sheenRoughnessFactor":0.5)")),
       cloth},
      {"transmission", with_extensions(glass, clear), glass},
      {"volume",
       with_extensions(glass, clear + "," +
                                  extension("volume", R"("thicknessFactor":0.08,"attenuationDistance":0.05,)"
                                                      R"("attenuationColor":[0.9,0.4,0.2])")),
       with_extensions(glass, clear)},
      {"ior", with_extensions(smooth, extension("ior", R"("ior":2.4)")), smooth},
      {"specular", with_extensions(smooth, extension("specular", R"("specularFactor":0)")), smooth},
      {"specular colour",
       with_extensions(smooth, extension("ior", R"("ior":1.8)") + "," +
                                   extension("specular", R"("specularColorFactor":[3,0.3,0.1])")),
       with_extensions(smooth, extension("ior", R"("ior":1.8)"))},
      {"unlit", with_extensions(grey, extension("unlit")), grey}};
}

std::vector<std::vector<std::uint8_t>> pictures() {
  std::vector<std::vector<std::uint8_t>> encoded;
  for (const Texture& texture : test::painted_textures()) {
    encoded.push_back(test::png_of(texture.width, texture.height, PNG_FORMAT_RGBA, texture.rgba));
    if (encoded.size() > 1) continue;
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < texture.rgba.size(); ++i)
      if (i % 4 != 3) rgb.push_back(texture.rgba[i]);
    encoded.push_back(test::jpeg_of(static_cast<int>(texture.width), static_cast<int>(texture.height), rgb));
  }
  return encoded;
}

// Its upper part is missing: what is seen of it from above is its inside.
Mesh bowl(Mesh ball) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
    const auto corners = std::span(ball.indices).subspan(i, 3);
    if (std::ranges::all_of(corners, [&](std::uint32_t at) { return ball.positions[at].y < 0.001F; }))
      kept.insert(kept.end(), corners.begin(), corners.end());
  }
  ball.indices = std::move(kept);
  return ball;
}

class GltfFeaturesTest : public test::LitScene {
protected:
  static constexpr Extent kExtent{640, 360};
  static constexpr float kRadius = 0.04F;  // m

  static glm::vec3 place(std::size_t i) {
    return {0.11F * (static_cast<float>(i % 7) - 3.0F), kRadius, 0.12F * (static_cast<float>(i / 7) - 1.0F)};
  }

  static void add_textures(test::LitGlb& balls) {
    balls.pictures = pictures();
    balls.textures = R"("samplers":[{"wrapS":33071,"wrapT":33071,"magFilter":9728}],"textures":[)";
    for (std::size_t i = 0; i < balls.pictures.size(); ++i)
      balls.textures += R"({"source":)" + std::to_string(i) + "},";
    balls.textures += R"({"source":0,"sampler":0}],)";
  }

  // Of each feature's ball, from the file that `material` says.
  Picture drawn(std::string Feature::*material) {
    Mesh ball = test::unwrapped_ball(kRadius);
    for (glm::vec4& uv : ball.uv) uv = {uv.x, uv.y, 0.5F * uv.x, 2.0F * uv.y};
    test::LitGlb balls;
    const std::vector<Feature> all = features();
    for (std::size_t i = 0; i < all.size(); ++i)
      balls.parts.push_back({all[i].name == std::string("double sided") ? bowl(ball) : ball, place(i),
                             "{" + all[i].*material + "}"});
    balls.extensions = {"KHR_texture_transform"};
    for (const char* name :
         {"clearcoat", "emissive_strength", "ior", "sheen", "specular", "transmission", "unlit", "volume"})
      balls.extensions.push_back(std::string("KHR_materials_") + name);
    add_textures(balls);
    folder_.write("scenarios/peg/lamps.glb", balls.bytes());
    VisualDesc desc = assembled("");
    desc.key_light.emplace().intensity = 1.2F;
    desc.ambient.intensity = 0.6F;
    return draw(*renderer(desc, kExtent, {4, 1024, 1.0F}), camera_, away());
  }

  // Mean difference of a colour's 255 values, over a square within the ball.
  double difference(const Picture& a, const Picture& b, std::size_t i) const {
    const glm::mat4 view = glm::lookAt(camera_.eye, camera_.target, glm::vec3(0, 1, 0));
    const float aspect = static_cast<float>(kExtent.width) / static_cast<float>(kExtent.height);
    const glm::vec4 at =
        glm::perspective(camera_.vertical_fov_rad, aspect, 0.01F, 10.0F) * view * glm::vec4(place(i), 1.0F);
    const auto x = static_cast<int>((0.5F + 0.5F * at.x / at.w) * static_cast<float>(kExtent.width)),
               y = static_cast<int>((0.5F - 0.5F * at.y / at.w) * static_cast<float>(kExtent.height));
    constexpr int kHalf = 18;
    double sum = 0;
    for (int row = y - kHalf; row < y + kHalf; ++row)
      for (int column = x - kHalf; column < x + kHalf; ++column)
        for (int channel = 0; channel < 3; ++channel) {
          const auto k =
              static_cast<std::size_t>(4 * (row * static_cast<int>(kExtent.width) + column) + channel);
          sum += std::abs(a.rgba[k] - b.rgba[k]);
        }
    return sum / (12.0 * kHalf * kHalf);
  }

  const Camera camera_{{0.0F, 0.75F, 1.0F}, {0.0F, 0.02F, 0.02F}, 0.39F};
};

TEST_F(GltfFeaturesTest, AllAreDrawnFromAFile) {
  const Picture with = drawn(&Feature::with), without = drawn(&Feature::without);
  const std::vector<Feature> all = features();
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_GT(difference(with, without, i), 3.0) << all[i].name << " makes no difference";
  const test::Comparison result =
      test::compare(with, std::filesystem::path(FULCRUM_GOLDENS) / "gltf_features.png",
                    {.max_lsb = 2, .max_pixels = 20, .failure_folder = FULCRUM_FAILURES});
  EXPECT_TRUE(result.passed) << result.sentence;
}

// What else a file says of it is for programs that light it all the same.
TEST_F(GltfFeaturesTest, WhatIsUnlitBuildsItsColourAlone) {
  const std::string textured = R"(,"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":2})";
  const std::string material =
      body(kWhite, "0.5", textured) +
      R"(,"normalTexture":{"index":3},"occlusionTexture":{"index":4},"emissiveTexture":{"index":5},)"
      R"("emissiveFactor":[1,1,1])";
  test::LitGlb ball;
  ball.parts = {{test::unwrapped_ball(kRadius), place(0),
                 "{" +
                     with_extensions(material, extension("unlit") + "," +
                                                   extension("clearcoat", R"("clearcoatFactor":1)")) +
                     "}"}};
  ball.extensions = {"KHR_materials_unlit", "KHR_materials_clearcoat"};
  add_textures(ball);
  folder_.write("scenarios/peg/lamps.glb", ball.bytes());
  const VisualDesc desc = assembled("");
  EXPECT_EQ(desc.textures.size(), 1U);
  const SceneFacts facts = facts_of(desc);
  EXPECT_EQ(facts.textures, 1U);
  const auto textured_look = std::ranges::find_if(facts.looks, reads_places);
  ASSERT_NE(textured_look, facts.looks.end());
  EXPECT_EQ(describe_look(*textured_look), "base colour texture, no light");
}

}  // namespace
}  // namespace fulcrum::render
