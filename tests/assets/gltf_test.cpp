#include "engine/assets/gltf.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "haptics/bake/solid.h"
#include "tests/assets/glb_builder.h"

namespace fulcrum {
namespace {

using glb::Tetrahedron;

std::string refusal(std::span<const std::byte> bytes) {
  const auto model = parse_glb(bytes, "part.glb");
  return model ? "" : model.error().sentence;
}
std::string refusal(const Tetrahedron& file) {
  return refusal(file.bytes());
}

#define EXPECT_MENTIONS(sentence, words) \
  EXPECT_NE(std::string(sentence).find(words), std::string::npos) << "says: " << (sentence)

TEST(Gltf, ReadsGeometryAndMaterial) {
  const auto model = parse_glb(Tetrahedron().bytes(), "part.glb");
  ASSERT_TRUE(model) << model.error().sentence;
  ASSERT_EQ(model->parts.size(), 1u);
  const ModelPart& part = model->parts[0];
  EXPECT_EQ(part.name, "body");
  EXPECT_EQ(part.indices.size(), 12u);
  ASSERT_EQ(part.normals.size(), part.positions.size());
  for (std::size_t i = 0; i < part.indices.size(); i += 3) {  // flat: the file has no normals
    const Vec3 &a = part.positions[part.indices[i]], &b = part.positions[part.indices[i + 1]],
               &c = part.positions[part.indices[i + 2]];
    EXPECT_NEAR((part.normals[part.indices[i]] - (b - a).cross(c - a).normalized()).norm(), 0.0, 1e-12);
  }
  const ModelMaterial& material = model->materials[part.material];
  EXPECT_EQ(material.name, "steel");
  EXPECT_FLOAT_EQ(material.base_colour[2], 0.3f);
  EXPECT_FLOAT_EQ(material.metallic, 0.9f);
  EXPECT_FLOAT_EQ(material.roughness, 0.25f);
  const auto solid = build_solid(to_triangle_mesh(*model));
  ASSERT_TRUE(solid) << solid.error().sentence;
  EXPECT_NEAR(solid->components[0].volume_m3, 1.0 / 6.0, 1e-12);
}

TEST(Gltf, NodesMoveTurnScaleAndMirror) {
  Tetrahedron file;
  file.scene = R"("scene":0,"scenes":[{"nodes":[1]}],)";
  file.nodes = R"([{"mesh":0,"scale":[-2,1,1]},{"children":[0,2],"translation":[0,0,5]},{"mesh":0,)"
               R"("matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,10,0,0,1]}])";
  const auto model = parse_glb(file.bytes(), "part.glb");
  ASSERT_TRUE(model) << model.error().sentence;
  ASSERT_EQ(model->parts.size(), 2u);
  Box3 mirrored, turned;
  for (const Vec3& p : model->parts[0].positions) mirrored.extend(p);
  for (const Vec3& p : model->parts[1].positions) turned.extend(p);
  EXPECT_NEAR((mirrored.min() - Vec3(-2, 0, 5)).norm() + (mirrored.max() - Vec3(0, 1, 6)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((turned.min() - Vec3(9, 0, 5)).norm() + (turned.max() - Vec3(10, 1, 6)).norm(), 0.0, 1e-12);
  const auto solid = build_solid(to_triangle_mesh(*model));  // wound outwards still
  ASSERT_TRUE(solid) << solid.error().sentence;
  EXPECT_EQ(solid->components.size(), 2u);
}

TEST(Gltf, VerticesMayHaveColours) {
  Tetrahedron file;
  file.primitive = R"({"attributes":{"POSITION":0,"COLOR_0":0},"indices":1,"material":0})";
  const auto model = parse_glb(file.bytes(), "part.glb");
  ASSERT_TRUE(model) << model.error().sentence;
  const ModelPart& part = model->parts[0];
  EXPECT_EQ(part.colours, part.positions);  // whose numbers are 0 and 1 as well
  EXPECT_TRUE(parse_glb(Tetrahedron().bytes(), "part.glb")->parts[0].colours.empty());
  file.primitive = R"({"attributes":{"POSITION":0,"COLOR_0":1},"indices":1,"material":0})";
  EXPECT_MENTIONS(refusal(file), "colours");
}

TEST(Gltf, EveryFaultIsASentence) {
  EXPECT_MENTIONS(refusal(std::span<const std::byte>{}), "part.glb: it is not a binary glTF file");
  std::vector<std::byte> bytes = Tetrahedron().bytes();
  EXPECT_MENTIONS(refusal(std::span(bytes).first(10)), "ends within its header");
  EXPECT_MENTIONS(refusal(std::span(bytes).first(bytes.size() - 8)), "it is truncated");
  bytes[0] = std::byte{'x'};
  EXPECT_MENTIONS(refusal(bytes), "not a binary glTF file; export");
  bytes = Tetrahedron().bytes();
  bytes[4] = std::byte{1};
  EXPECT_MENTIONS(refusal(bytes), "not of glTF version 2");
  bytes = Tetrahedron().bytes();
  bytes[20] = std::byte{'['};
  EXPECT_MENTIONS(refusal(bytes), "cannot be read as glTF");

  Tetrahedron file;
  file.indices[5] = 4;
  EXPECT_MENTIONS(refusal(file), "refers to vertex 4 of 4");
  file = {};
  file.positions[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_MENTIONS(refusal(file), "vertex 2 of a mesh is not a finite number");
  file = {};
  file.views =
      R"([{"buffer":0,"byteOffset":40,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}])";
  EXPECT_MENTIONS(refusal(file), "beyond its buffer");
  file = {};
  file.accessors = R"([{"bufferView":0,"componentType":5126,"count":400000000000,"type":"VEC3"},)"
                   R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}])";
  EXPECT_MENTIONS(refusal(file), "beyond its buffer view");
  file = {};
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"mode":1})";
  EXPECT_MENTIONS(refusal(file), "no triangles");
  file = {};
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"mode":5})";
  EXPECT_MENTIONS(refusal(file), "export it as plain triangles");
  file = {};
  file.nodes = R"([{"children":[0],"mesh":0}])";
  EXPECT_MENTIONS(refusal(file), "its own ancestor");
  file = {};
  file.nodes = R"([{"name":"flat","mesh":0,"scale":[1,0,1]}])";
  EXPECT_MENTIONS(refusal(file), "part 'flat' is scaled to nothing");
  file = {};
  file.nodes = R"([{"name":"far","mesh":0,"translation":[0,2e5,0]}])";
  EXPECT_MENTIONS(refusal(file), "part 'far' is moved or scaled out of all bounds");
  file = {};
  file.nodes = R"([{"name":"odd","mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2]}])";
  EXPECT_MENTIONS(refusal(file), "node 'odd' has a matrix whose last row is not 0, 0, 0, 1");
  file = {};
  file.nodes = R"([{"mesh":0,"children":[7]}])";
  EXPECT_MENTIONS(refusal(file), "a node that it does not hold");
}

TEST(Gltf, WhatIsNotSupportedSaysSo) {
  Tetrahedron file;
  file.more = R"("extensionsRequired":["KHR_draco_mesh_compression"],)";
  EXPECT_MENTIONS(refusal(file), "without mesh compression");
  file = {};
  file.accessors = R"([{"bufferView":0,"componentType":5122,"count":4,"type":"VEC3"},)"
                   R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}])";
  EXPECT_MENTIONS(refusal(file), "quantised");
  file = {};
  file.accessors = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,)"
                   R"("indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0}}},)"
                   R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}])";
  EXPECT_MENTIONS(refusal(file), "sparse accessors");
}

// What moves a mesh is left out with a clause, each kind once; what is not there is not told.
TEST(Gltf, WhatDeformsOrIsNoSurfaceIsToldOf) {
  const auto told = [](const Tetrahedron& file) {
    const auto model = parse_glb(file.bytes(), "part.glb");
    if (!model) ADD_FAILURE() << model.error().sentence;
    std::string all;
    if (model)
      for (const std::string& clause : model->left_out) all += clause + "|";
    return all;
  };
  Tetrahedron file;
  EXPECT_EQ(told(file), "");
  const std::string plain = file.primitive;
  const auto moded = [](int mode) {
    return R"({"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + "}";
  };
  file.primitive = plain + "," + moded(0) + "," + moded(0);
  EXPECT_EQ(told(file), "points, which are no surface|");
  file.primitive = plain + "," + moded(0) + "," + moded(1) + "," + moded(2) + "," + moded(3);
  EXPECT_EQ(told(file), "points, which are no surface|lines, which are no surface|");
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0,"targets":[{"POSITION":0}]})";
  EXPECT_EQ(told(file), "morph targets: the mesh is seen and felt as it is without them|");
  file = {};
  file.nodes = R"([{"mesh":0,"skin":0},{"mesh":0,"skin":0}])";
  file.scene = "";
  file.more = R"("skins":[{"joints":[0]}],)";
  EXPECT_EQ(told(file), "skins: the mesh is seen and felt where its node puts it, undeformed|");
  file = {};
  file.more = R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)"
              R"("samplers":[{"input":0,"output":0}]}],)";
  EXPECT_EQ(told(file), "animations: all is seen and felt at rest|");
}

// What a file calls its parts gets into sentences, and to a terminal.
TEST(Gltf, NamesStayOnOneLine) {
  Tetrahedron file;
  file.nodes = R"([{"name":"bo\ndy\u001b","mesh":0}])";
  file.material = R"({"name":"ste\nel"})";
  const auto model = parse_glb(file.bytes(), "part.glb");
  ASSERT_TRUE(model) << model.error().sentence;
  EXPECT_EQ(model->parts[0].name, "bo dy ");
  EXPECT_EQ(model->materials[0].name, "ste el");
  for (const char* rest : {R"(,"scale":[1,0,1])", R"(,"translation":[0,2e5,0])", R"(,"rotation":[0,0,0,0])",
                           R"(,"translation":[1])", R"(,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2])"}) {
    file.nodes = R"([{"name":"bo\ndy","mesh":0)" + std::string(rest) + "}]";
    EXPECT_MENTIONS(refusal(file), "'bo dy'") << rest;
  }
  file.nodes = R"([{"name":"bo\ndy","mesh":7}])";
  EXPECT_MENTIONS(refusal(file), "node 'bo dy' refers");
}

TEST(Gltf, NestingCannotExhaustTheStack) {
  Tetrahedron file;
  file.more = R"("extras":)" + std::string(200000, '[') + std::string(200000, ']') + ",";
  EXPECT_MENTIONS(refusal(file), "nested");
}

// A string may end in a backslash, and brackets in strings are none.
TEST(Gltf, NestingIsCountedAsTheParserReads) {
  Tetrahedron file;
  for (const char* before : {R"("x":"\\",)", R"("x":"\"[",)", R"("x":"[[\\\"[[",)", R"("x":["\\"],)"}) {
    for (const char* open : {"[", R"({"a":)"}) {
      const std::string close = *open == '[' ? "]" : "}";
      std::string deep, end;
      for (int i = 0; i < 20000; ++i) {
        deep += open;
        end += close;
      }
      file.more = before + (R"("extras":)" + deep + "1" + end) + ",";
      EXPECT_MENTIONS(refusal(file), "nested") << before << open;
    }
  }
  file.more = R"("x":")" + std::string(1000, '[') + R"(\\","extras":)" + std::string(100, '[') +
              std::string(100, ']') + ",";
  EXPECT_EQ(refusal(file), "");
}

TEST(Gltf, FilesThatCannotBeReadSaySo) {
  const auto missing = load_gltf("/nonexistent", "/nonexistent/part.glb");
  ASSERT_FALSE(missing);
  EXPECT_MENTIONS(missing.error().sentence, "/nonexistent/part.glb: No such file");
  const auto folder = load_gltf("/", std::filesystem::temp_directory_path());
  ASSERT_FALSE(folder);
  EXPECT_MENTIONS(folder.error().sentence, "a folder");
}

// FOLDER/models/part.gltf, whose buffer is another file.
class GltfText : public testing::Test {
protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "models");
    std::ofstream(top_ / "secret.bin", std::ios::binary) << buffer_;
    std::ofstream(folder_ / "near.bin", std::ios::binary) << buffer_;
    std::ofstream(folder_ / "models" / "part.bin", std::ios::binary) << buffer_;
  }
  void TearDown() override { std::filesystem::remove_all(top_); }

  // What is said about a buffer of that URI.
  std::string refusal_of(const std::string& uri, const std::string& more = "") {
    std::string json = json_;
    const std::string embedded = R"("buffers":[{)";
    json.insert(json.find(embedded) + embedded.size(), R"("uri":")" + uri + R"(",)");
    json.insert(1, more);
    std::ofstream(file_) << json;
    const auto model = load_gltf(folder_, file_);
    return model ? "" : model.error().sentence;
  }

  const std::vector<std::byte> bytes_ = Tetrahedron().bytes();
  const std::size_t json_bytes_ =
      std::to_integer<std::size_t>(bytes_[12]) + 256 * std::to_integer<std::size_t>(bytes_[13]);
  const std::string json_{reinterpret_cast<const char*>(bytes_.data()) + 20, json_bytes_};
  const std::string buffer_{reinterpret_cast<const char*>(bytes_.data()) + 28 + json_bytes_, 72};
  const std::filesystem::path top_ =
      std::filesystem::path(testing::TempDir()) / ("fulcrum_gltf_test_" + std::to_string(::getpid()));
  const std::filesystem::path folder_ = top_ / "scenario";
  const std::filesystem::path file_ = folder_ / "models" / "part.gltf";
};

TEST_F(GltfText, FindsItsBufferInItsFolder) {
  EXPECT_EQ(refusal_of("part.bin"), "");
  EXPECT_EQ(refusal_of("../near.bin"), "");
  std::filesystem::create_symlink("../near.bin", folder_ / "models" / "link.bin");
  EXPECT_EQ(refusal_of("link.bin"), "");
  EXPECT_MENTIONS(refusal_of("none.bin"), "it names the file " + (folder_ / "models/none.bin").string());
  EXPECT_MENTIONS(refusal_of("no%0Ane.bin"),
                  (folder_ / "models/no ne.bin").string() + ", which cannot be read");
  EXPECT_MENTIONS(refusal_of("near.bin"), "No such file");  // not where the scenario or the program is
}

TEST_F(GltfText, ReadsNothingOutsideItsFolder) {
  std::filesystem::create_symlink(top_ / "secret.bin", folder_ / "models" / "out.bin");
  std::filesystem::create_symlink("..", folder_ / "up");
  for (const char* uri : {"../../secret.bin", "..%2f..%2Fsecret.bin", "out.bin", "../up/secret.bin"})
    EXPECT_MENTIONS(refusal_of(uri), "leads out of the folder") << uri;
  EXPECT_NE(refusal_of((top_ / "secret.bin").string()), "");
  EXPECT_NE(refusal_of("file://" + (top_ / "secret.bin").string()), "");
  std::filesystem::rename(file_, top_ / "part.gltf");
  std::filesystem::create_symlink("../../part.gltf", file_);
  EXPECT_MENTIONS(load_gltf(folder_, file_).error().sentence, "leads out of the folder");
}

// As of a buffer, the reason is told, and of each image its own; the model is read without them.
TEST_F(GltfText, SaysWhyAnImageCannotBeRead) {
  std::filesystem::create_symlink(top_ / "secret.bin", folder_ / "models" / "out.png");
  std::ofstream(folder_ / "models" / "empty.png");
  std::ofstream(folder_ / "models" / "there.png", std::ios::binary) << buffer_;
  const std::string more =
      R"("images":[{"uri":"none.png","name":"grain"},{"uri":"there.png"},{"uri":"data:image/png;base64,AAAA"},)"
      R"({"uri":"out.png"},{"uri":"em%70ty.png"}],"textures":[{"source":0},{"source":1},{"source":2},)"
      R"({"source":3},{"source":4}],)";
  std::string json = json_;
  const std::string material = R"("pbrMetallicRoughness":{)";
  json.insert(json.find(material),
              R"("normalTexture":{"index":1},"occlusionTexture":{"index":3},"emissiveFactor":[1,1,1],)"
              R"("emissiveTexture":{"index":4},)");
  json.insert(json.find(material) + material.size(),
              R"("baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":2},)");
  const std::string embedded = R"("buffers":[{)";
  json.insert(json.find(embedded) + embedded.size(), R"("uri":"part.bin",)");
  json.insert(1, more);
  std::ofstream(file_) << json;
  const auto model = load_gltf(folder_, file_);
  ASSERT_TRUE(model) << model.error().sentence;
  const std::string cure = "): export the model as .glb, which holds its textures";
  const std::vector<std::string> told{
      "the texture none.png, which cannot be read (No such file or directory" + cure,
      "the texture number 2, which is neither PNG nor JPEG",
      "the texture there.png, which is neither PNG nor JPEG",
      "the texture out.png, which cannot be read (it leads out of the folder " + folder_.string() +
          "; copy the file there" + cure,
      "the texture em%70ty.png, which cannot be read (it is empty" + cure};
  EXPECT_EQ(model->left_out, told);
}

// A pipe without a writer would be waited for.
TEST_F(GltfText, ReadsFilesAlone) {
  ASSERT_EQ(::mkfifo((folder_ / "models" / "pipe").c_str(), 0600), 0);
  EXPECT_MENTIONS(refusal_of("pipe"), "it is a pipe, not a file");
  EXPECT_MENTIONS(refusal_of("."), "it is a folder, not a file");
  EXPECT_EQ(refusal_of("part.bin", R"("images":[{"uri":"pipe"},{"uri":"../../secret.bin"}],)"), "");
  EXPECT_MENTIONS(load_gltf(folder_, folder_ / "models" / "pipe").error().sentence, "it is a pipe");
}

}  // namespace
}  // namespace fulcrum
