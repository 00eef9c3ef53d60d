// What a file says of its surfaces: textures, transparency and the extensions of materials.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/assets/gltf.h"
#include "tests/assets/textured.h"

namespace fulcrum {
namespace {

using test::Textured;

TEST(GltfMaterial, ReadsATextureAndWhereItLies) {
  const Model model =
      Textured(
          R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":)"
          R"({"offset":[0.25,0.5],"rotation":1.5,"scale":[2,3]}}}}})")
          .read();
  ASSERT_EQ(model.images.size(), 1U);
  EXPECT_EQ(model.images[0].name, "grain");
  EXPECT_EQ(model.images[0].encoded, test::png_of(1, 1, PNG_FORMAT_RGB, {1, 2, 3}));
  ASSERT_TRUE(model.materials[0].detail);
  const TextureUse& use = model.materials[0].detail->base_colour.value();
  EXPECT_EQ(use.wrap_u, TextureWrap::clamp);
  EXPECT_EQ(use.wrap_v, TextureWrap::mirror);
  EXPECT_TRUE(use.nearest);
  EXPECT_EQ(use.offset, (std::array<float, 2>{0.25F, 0.5F}));
  EXPECT_EQ(use.scale, (std::array<float, 2>{2, 3}));
  EXPECT_EQ(use.rotation, 1.5F);
  ASSERT_EQ(model.parts[0].uv.size(), model.parts[0].positions.size());
  // Shaded flat, each corner has its own vertex: the first triangle is 0, 2, 1.
  EXPECT_EQ(model.parts[0].uv[1], (std::array<float, 4>{0, 1, 0, 0}));
  EXPECT_TRUE(model.left_out.empty());
}

TEST(GltfMaterial, ReadsWhatTheExtensionsSay) {
  const Model model =
      Textured(
          R"({"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true,"emissiveFactor":[0.5,0,1],)"
          R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.5]},"normalTexture":{"index":0,"scale":0.5},)"
          R"("occlusionTexture":{"index":0,"strength":0.75},"extensions":{"KHR_materials_emissive_strength":)"
          R"({"emissiveStrength":4},"KHR_materials_ior":{"ior":1.8},"KHR_materials_specular":{"specularFactor":)"
          R"(0.5,"specularColorFactor":[1,0.5,0]},"KHR_materials_clearcoat":{"clearcoatFactor":0.75,)"
          R"("clearcoatRoughnessFactor":0.5},"KHR_materials_sheen":{"sheenColorFactor":[0.5,0.25,0],)"
          R"("sheenRoughnessFactor":0.5},"KHR_materials_transmission":{"transmissionFactor":0.5}}})")
          .read();
  const MaterialDetail& detail = model.materials[0].detail.value();
  EXPECT_EQ(detail.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(detail.alpha_cutoff, 0.25F);
  EXPECT_EQ(detail.alpha, 0.5F);
  EXPECT_TRUE(detail.double_sided);
  EXPECT_EQ(detail.emission, (std::array<float, 3>{2, 0, 4}));
  EXPECT_EQ(detail.normal_scale, 0.5F);
  EXPECT_EQ(detail.occlusion_strength, 0.75F);
  EXPECT_EQ(detail.ior, 1.8F);
  EXPECT_EQ(detail.specular, 0.5F);
  EXPECT_EQ(detail.specular_colour, (std::array<float, 3>{1, 0.5F, 0}));
  EXPECT_EQ(detail.clearcoat, 0.75F);
  EXPECT_EQ(detail.clearcoat_roughness, 0.5F);
  EXPECT_EQ(detail.sheen, (std::array<float, 3>{0.5F, 0.25F, 0}));
  EXPECT_EQ(detail.sheen_roughness, 0.5F);
  EXPECT_EQ(detail.transmission, 0.5F);
  EXPECT_EQ(model.images.size(), 1U) << "one picture, however often it is named";
}

TEST(GltfMaterial, ReadsTheOddestNumbersAsTheyAreMeant) {
  const auto detail = [](const std::string& material) {
    return Textured(material).read().materials[0].detail.value();
  };
  EXPECT_EQ(detail(R"({"extensions":{"KHR_materials_ior":{"ior":0}}})").ior, 0.0F) << "all is mirrored";
  EXPECT_EQ(detail(R"({"extensions":{"KHR_materials_ior":{"ior":0.5}}})").ior, 1.0F);
  EXPECT_EQ(detail(R"({"alphaMode":"MASK","alphaCutoff":2})").alpha_cutoff, 2.0F) << "nothing of it is there";
}

// A distance of 2 cm behind which a quarter, a half and all is left, and 1 cm of it; a wall without
// thickness takes nothing away, nor does what transmits nothing.
TEST(GltfMaterial, AVolumeTakesWhatItsThicknessDoes) {
  const auto passed = [](const std::string& transmission, const std::string& volume) {
    const Model model =
        Textured(R"({"doubleSided":true,"extensions":{"KHR_materials_transmission":{"transmissionFactor":)" +
                 transmission + R"(},"KHR_materials_volume":)" + volume + "}}")
            .read();
    EXPECT_TRUE(model.left_out.empty());
    return model.materials[0].detail.value().passed;
  };
  const std::string colour = R"("attenuationDistance":0.02,"attenuationColor":[0.25,0.5,1])";
  const std::array<float, 3> behind = passed("1", R"({"thicknessFactor":0.01,)" + colour + "}");
  EXPECT_NEAR(behind[0], 0.5F, 1e-6F);
  EXPECT_NEAR(behind[1], std::sqrt(0.5F), 1e-6F);
  EXPECT_EQ(behind[2], 1.0F);
  constexpr std::array<float, 3> kAll{1, 1, 1};
  EXPECT_EQ(passed("1", "{" + colour + "}"), kAll);
  EXPECT_EQ(passed("1", R"({"thicknessFactor":0.01,"attenuationColor":[0.25,0.5,1]})"), kAll);
  EXPECT_EQ(passed("0", R"({"thicknessFactor":0.01,)" + colour + "}"), kAll);
  for (const char* odd :
       {R"({"thicknessFactor":-1,"attenuationDistance":0,"attenuationColor":[0,2,1]})", "7",
        R"({"thicknessFactor":1e30,"attenuationDistance":1e-30,"attenuationColor":[0,0,0]})"})
    for (const float part : passed("1", odd)) EXPECT_TRUE(part >= 0.0F && part <= 1.0F) << odd;
}

// KHR_materials_volume: a thickness is one of the mesh, and its node makes it larger; a distance is one of
// the scene.
TEST(GltfMaterial, AVolumeIsAsThickAsItsNodeMakesIt) {
  Textured glass(R"({"name":"glass","extensions":{"KHR_materials_transmission":{"transmissionFactor":1},)"
                 R"("KHR_materials_volume":{"thicknessFactor":10,"attenuationDistance":0.02,)"
                 R"("attenuationColor":[0.25,0.5,1]}}})");
  glass.file.scene = R"("scene":0,"scenes":[{"nodes":[0,1,3]}],)";
  glass.file.nodes = R"([{"mesh":0,"scale":[0.001,0.001,0.001]},{"scale":[0.01,0.01,0.01],"children":[2]},)"
                     R"({"mesh":0,"scale":[-0.2,0.2,0.2],"rotation":[0.6,0,0,0.8]},)"
                     R"({"mesh":0,"scale":[0.001,0.001,0.001],"rotation":[0,0.6,0,0.8]}])";
  const Model model = glass.read();
  ASSERT_EQ(model.parts.size(), 3U);
  const auto passed = [&](std::size_t part) {
    return model.materials[model.parts[part].material].detail.value().passed;
  };
  EXPECT_NEAR(passed(0)[0], 0.5F, 1e-3F) << "10 mm";
  EXPECT_NEAR(passed(1)[0], 0.25F, 1e-3F) << "20 mm, mirrored";
  EXPECT_EQ(passed(1)[2], 1.0F);
  EXPECT_EQ(model.parts[2].material, model.parts[0].material) << "as large, and turned";
  for (const ModelPart& part : model.parts) EXPECT_EQ(model.materials[part.material].name, "glass");
}

// The far side of a volume is part of it; a thin wall has a back where the file says so.
TEST(GltfMaterial, AVolumeHasNoBackOfItsOwn) {
  const auto has_back = [](const std::string& volume) {
    return Textured(
               R"({"doubleSided":true,"extensions":{"KHR_materials_transmission":{"transmissionFactor":1})" +
               volume + "}}")
        .read()
        .materials[0]
        .detail.value()
        .double_sided;
  };
  EXPECT_FALSE(has_back(R"(,"KHR_materials_volume":{"thicknessFactor":0.01})"));
  EXPECT_TRUE(has_back(R"(,"KHR_materials_volume":{})"));
  EXPECT_TRUE(has_back(""));
}

// Parts of a mesh may share all its vertices: each keeps those that it shows.
TEST(GltfMaterial, APartHasTheVerticesThatItShows) {
  Textured file(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})");
  file.file.primitive = R"({"attributes":{"POSITION":0,"NORMAL":0,"TEXCOORD_0":2},"indices":1,"material":0})";
  const Model whole = file.read();
  ASSERT_EQ(whole.parts[0].positions.size(), 4U);
  file.file.accessors.replace(file.file.accessors.find("\"count\":12"), 10, "\"count\":3");
  const Model one = file.read();
  ASSERT_EQ(one.parts[0].indices.size(), 3U);
  EXPECT_EQ(one.parts[0].positions.size(), 3U);
  EXPECT_EQ(one.parts[0].normals.size(), 3U);
  EXPECT_EQ(one.parts[0].uv.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t was = whole.parts[0].indices[i], is = one.parts[0].indices[i];
    EXPECT_EQ(one.parts[0].positions[is], whole.parts[0].positions[was]);
    EXPECT_EQ(one.parts[0].uv[is], whole.parts[0].uv[was]);
  }
}

// Twenty millimetres in micrometres, and a distance as long again as one may be.
TEST(GltfMaterial, AVolumeMayBeInMicrometres) {
  Textured glass(R"({"name":"glass","extensions":{"KHR_materials_transmission":{"transmissionFactor":1},)"
                 R"("KHR_materials_volume":{"thicknessFactor":20000,"attenuationDistance":0.02,)"
                 R"("attenuationColor":[0.25,0.5,1]}}})");
  glass.file.nodes = R"([{"mesh":0,"scale":[1e-6,1e-6,1e-6]}])";
  const Model model = glass.read();
  EXPECT_NEAR(model.materials[model.parts[0].material].detail.value().passed[0], 0.25F, 1e-3F);
}

// A mesh that does not say where a texture lies is drawn without it, and its other parts with it.
TEST(GltfMaterial, ATextureIsLaidOnWhatHasItsCoordinates) {
  const std::string both = R"({"name":"both","occlusionTexture":{"index":0,"texCoord":1,"strength":0.5},)"
                           R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  const auto reads = [](const Model& model) {
    const ModelMaterial& material = model.materials[model.parts[0].material];
    EXPECT_EQ(material.name, "both");
    std::string found;
    if (material.detail && material.detail->base_colour) found += "base ";
    if (material.detail && material.detail->occlusion) found += "occlusion ";
    return found + (material.detail ? "" : "plain");
  };
  Textured file(both);
  const Model one = file.read();
  EXPECT_EQ(reads(one), "base ");
  EXPECT_EQ(one.left_out,
            std::vector<std::string>{"textures on a mesh without their coordinates (TEXCOORD_1)"});
  file.file.primitive =
      R"({"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":2},"indices":1,"material":0})";
  EXPECT_EQ(reads(file.read()), "base occlusion ");
  EXPECT_TRUE(file.read().left_out.empty());
  file.file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0})";
  EXPECT_EQ(reads(file.read()), "plain");
  EXPECT_EQ(file.read().left_out.size(), 2U);
}

// What names no picture is read whatever its coordinates are.
TEST(GltfMaterial, CoordinatesThatNothingNeedsAreNotRead) {
  Textured file(R"({"name":"plain"})");
  file.file.accessors.replace(file.file.accessors.find("VEC2"), 4, "MAT4");
  EXPECT_TRUE(parse_glb(file.file.bytes(), "a.glb"));
}

TEST(GltfMaterial, APlainOneHasNoDetailAndKeepsNoCoordinates) {
  const Model model = Textured(R"({"pbrMetallicRoughness":{"metallicFactor":0.5}})").read();
  EXPECT_FALSE(model.materials[0].detail);
  EXPECT_TRUE(model.parts[0].uv.empty());
  EXPECT_TRUE(model.images.empty());
}

TEST(GltfMaterial, SaysWhatIsNotDrawn) {
  const auto left_out = [](const Textured& file) { return file.read().left_out; };
  const auto has = [](const std::vector<std::string>& list, const std::string& words) {
    return std::ranges::any_of(
        list, [&](const std::string& clause) { return clause.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(
      has(left_out(Textured(R"({"name":"plain"})", R"("extensionsUsed":["KHR_materials_variants"],)")),
          "KHR_materials_variants"));
  Textured faint(R"({"alphaMode":"BLEND"})");
  faint.file.primitive = R"({"attributes":{"POSITION":0,"COLOR_0":2},"indices":1,"material":0})";
  const std::string pairs = R"("componentType":5126,"count":4,"type":"VEC2")";
  faint.file.accessors.replace(faint.file.accessors.find(pairs), pairs.size(),
                               R"("componentType":5121,"count":4,"type":"VEC4","normalized":true)");
  EXPECT_TRUE(has(left_out(faint), "the alpha of vertices"));
  const std::string base = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  EXPECT_TRUE(
      has(left_out(Textured(R"({"extensions":{"KHR_materials_iridescence":{"iridescenceFactor":1}}})")),
          "KHR_materials_iridescence"));
  EXPECT_TRUE(has(left_out(Textured(R"({"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1,)"
                                    R"("clearcoatTexture":{"index":0}}}})")),
                  "KHR_materials_clearcoat's own textures"));
  EXPECT_TRUE(
      has(left_out(Textured(base, R"("textures":[{"extensions":{"KHR_texture_basisu":{"source":0}}}],)")),
          "neither PNG nor JPEG"));
  Textured webp(base);
  std::fill(webp.file.appended.begin() + 32, webp.file.appended.end(), std::byte{'w'});
  EXPECT_TRUE(has(left_out(webp), "the texture grain, which is neither PNG nor JPEG"));
  EXPECT_FALSE(webp.read().materials[0].detail);
}

// Nobody sees what no mesh is made of: its textures are not kept, and nothing is told of it.
TEST(GltfMaterial, WhatNoMeshIsMadeOfIsNotToldOf) {
  Textured file(
      R"({"name":"plain"},{"name":"spare","pbrMetallicRoughness":{"baseColorTexture":{"index":0},)"
      R"("metallicFactor":0.5},"extensions":{"KHR_materials_iridescence":{"iridescenceFactor":1}}})",
      R"("textures":[{"source":0}],"extensionsUsed":["KHR_materials_iridescence"],)");
  Model model = file.read();
  EXPECT_TRUE(model.left_out.empty()) << model.left_out[0];
  EXPECT_TRUE(model.images.empty());
  ASSERT_EQ(model.materials.size(), 3U);
  EXPECT_EQ(model.materials[1].name, "spare");
  EXPECT_EQ(model.materials[1].metallic, 0.5F);
  file.file.primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":1})";
  model = file.read();
  EXPECT_EQ(model.left_out, std::vector<std::string>{"KHR_materials_iridescence"});
  EXPECT_EQ(model.images.size(), 1U);
}

// What would be read out of bounds is refused: tinygltf checks no image's place in its buffer.
TEST(GltfMaterial, PicturesBeyondTheirBufferAreRefused) {
  Textured file(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})");
  const std::string honest = "\"byteLength\":" + std::to_string(file.png.size());
  file.file.views.replace(file.file.views.find(honest), honest.size(), "\"byteLength\":100000000");
  const auto refused = parse_glb(file.file.bytes(), "a.glb");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("reaches beyond its buffer"), std::string::npos)
      << refused.error().sentence;
}

TEST(GltfMaterial, TexturesThatAreNotThereAreRefused) {
  const auto sentence = [](const std::string& more) {
    const auto refused = parse_glb(
        Textured(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})", more).file.bytes(), "a.glb");
    return refused ? std::string() : refused.error().sentence;
  };
  EXPECT_NE(sentence(R"("textures":[],)").find("a texture that the file does not hold"), std::string::npos);
  EXPECT_NE(sentence(R"("textures":[{"source":5}],)").find("an image that the file does not hold"),
            std::string::npos);
}

}  // namespace
}  // namespace fulcrum
