// Lights that a file brings (KHR_lights_punctual): which there are, where its nodes put them, and that files
// which cannot be meant are refused with a sentence.

#include <gtest/gtest.h>

#include <numbers>

#include "engine/assets/gltf.h"
#include "tests/assets/glb_builder.h"

namespace fulcrum {
namespace {

using Kind = ModelLight::Kind;

// A tetrahedron, these lights, and a node for each of `nodes` beside its own.
glb::Tetrahedron lit(const std::string& lights, const std::string& nodes) {
  glb::Tetrahedron file;
  file.more = R"("extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[)" +
              lights + "]}},";
  file.nodes = R"([{"name":"body","mesh":0},)" + nodes + "]";
  file.scene = "";  // every node that has no parent is in it
  return file;
}

// Of a node with that light, before the rest of it.
std::string node(int light, const std::string& rest = "") {
  return R"({"name":"holder","extensions":{"KHR_lights_punctual":{"light":)" + std::to_string(light) + "}}" +
         rest + "}";
}

std::vector<ModelLight> lights_of(const glb::Tetrahedron& file) {
  const auto model = parse_glb(file.bytes(), "lit.glb");
  if (!model) ADD_FAILURE() << model.error().sentence;
  return model ? model->lights : std::vector<ModelLight>();
}

std::string refusal(const std::string& light, const std::string& holder = node(0)) {
  const auto model = parse_glb(lit(light, holder).bytes(), "lit.glb");
  return model ? "" : model.error().sentence;
}

TEST(GltfLight, ReadsTheThreeKinds) {
  const auto lights = lights_of(
      lit(R"({"type":"directional","name":"sun","intensity":3000,"color":[1,0.5,0.25]},)"
          R"({"type":"point","range":2.5},)"
          R"({"type":"spot","name":"lamp","intensity":5,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.3}})",
          node(0) + "," + node(1)));
  ASSERT_EQ(lights.size(), 2u) << "one that no node refers to shines nowhere";
  EXPECT_EQ(lights[0].kind, Kind::directional);
  EXPECT_EQ(lights[0].name, "sun");
  EXPECT_EQ(lights[0].intensity, 3000);
  EXPECT_EQ(lights[0].colour, (std::array<float, 3>{1, 0.5F, 0.25F}));
  EXPECT_FALSE(lights[0].range);
  EXPECT_EQ(lights[1].kind, Kind::point);
  EXPECT_EQ(lights[1].name, "holder") << "its node's, without one of its own";
  EXPECT_EQ(lights[1].intensity, 1);
  EXPECT_EQ(lights[1].colour, (std::array<float, 3>{1, 1, 1}));
  EXPECT_EQ(lights[1].range, 2.5);

  const auto spots = lights_of(lit(
      R"({"type":"spot","intensity":40,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.3}},{"type":"spot","spot":{}})",
      node(0) + "," + node(1)));
  ASSERT_EQ(spots.size(), 2u);
  EXPECT_EQ(spots[0].kind, Kind::spot);
  EXPECT_EQ(spots[0].inner_cone, 0.1);
  EXPECT_EQ(spots[0].outer_cone, 0.3);
  EXPECT_EQ(spots[1].inner_cone, 0);
  EXPECT_NEAR(spots[1].outer_cone, std::numbers::pi / 4, 1e-9);
}

TEST(GltfLight, AModelWithoutOneHasNone) {
  EXPECT_TRUE(lights_of(glb::Tetrahedron()).empty());
}

// Turned a quarter about y, what looks along -z looks along -x; its parent moves, enlarges and mirrors it.
TEST(GltfLight, ItsNodesPlaceItAndLeaveItsNumbers) {
  const std::string holder =
      R"({"children":[2],"translation":[1,2,3],"scale":[-2,2,2]},)" +
      node(0, R"(,"translation":[0.5,0,0],"rotation":[0,0.70710678118654752,0,0.70710678118654752])");
  const auto lights = lights_of(lit(R"({"type":"spot","intensity":7,"range":4,"spot":{}})", holder));
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_NEAR((lights[0].position_M - Vec3(0, 2, 3)).norm(), 0, 1e-12);
  EXPECT_NEAR((lights[0].direction_M - Vec3(1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(lights[0].intensity, 7);
  EXPECT_EQ(lights[0].range, 4);
}

TEST(GltfLight, MarksAreThoseOfItsObject) {
  const auto lights = lights_of(lit(R"({"type":"point"})", node(0, R"(,"extras":{"fulcrum_role":"tool"})")));
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].marked_role, "tool");
}

TEST(GltfLight, WhatCannotBeMeantIsRefusedWithASentence) {
  const struct {
    const char *light, *says;
  } refused[] = {
      {R"({"type":"area"})", "is of a type that KHR_lights_punctual does not have"},
      {R"({"name":"x"})", "cannot be read as glTF"},
      {R"({"type":"point","intensity":-1})", "'intensity' that is less than zero"},
      {R"({"type":"point","intensity":"much"})", "'intensity' that is no number"},
      {R"({"type":"point","intensity":1e999})", "lit.glb: "},
      {R"({"type":"point","intensity":NaN})", "lit.glb: "},
      {R"({"type":"point","range":0})", "a range of zero"},
      {R"({"type":"point","range":-2})", "'range' that is less than zero"},
      {R"({"type":"point","range":[1]})", "'range' that is no number"},
      {R"({"type":"point","color":[1,1]})", "not of three numbers"},
      {R"({"type":"point","color":[1,-1,1]})", "a colour that is less than zero"},
      {R"({"type":"spot"})", "cannot be read as glTF"},
      {R"({"type":"spot","spot":{"innerConeAngle":0.5,"outerConeAngle":0.4}})", "wider than the outer one"},
      {R"({"type":"spot","spot":{"innerConeAngle":-0.5}})", "less than zero or wider"},
      {R"({"type":"spot","spot":{"outerConeAngle":"wide"}})", "'outerConeAngle' that is no number"},
      {R"({"type":"spot","spot":{"outerConeAngle":1.6}})", "at most pi / 2"},
      {R"({"type":"spot","spot":{"outerConeAngle":0}})", "at most pi / 2"},
  };
  for (const auto& [light, says] : refused) {
    const std::string sentence = refusal(light);
    EXPECT_TRUE(sentence.starts_with("lit.glb: ") && sentence.ends_with(".")) << light << ": " << sentence;
    EXPECT_NE(sentence.find(says), std::string::npos) << light << ": " << sentence;
  }
  EXPECT_EQ(refusal(R"({"type":"spot","spot":{"innerConeAngle":0.4,"outerConeAngle":0.4}})"), "");
  EXPECT_EQ(refusal(R"({"type":"spot","spot":{"outerConeAngle":1.5707963705}})"), "") << "pi / 2 as a float";
}

// A lamp of 2000 cd in a file of micrometres. What is too bright, the scene says, which knows the unit.
TEST(GltfLight, HowBrightItMayBeDependsOnTheUnit) {
  const auto lights = lights_of(lit(R"({"type":"point","intensity":2e15,"range":1e9})", node(0)));
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].intensity, 2e15);
  EXPECT_EQ(lights[0].range, 1e9);
}

TEST(GltfLight, ItsNameStaysOnOneLine) {
  const std::string holder = R"({"name":"hol\nder","extensions":{"KHR_lights_punctual":{"light":0}}})";
  EXPECT_EQ(lights_of(lit(R"({"type":"point","name":"a\nb\u001b[31m\u202e"})", node(0)))[0].name,
            "a b [31m ");
  EXPECT_EQ(lights_of(lit(R"({"type":"point"})", holder))[0].name, "hol der");
  EXPECT_NE(refusal(R"({"type":"point","name":"a\nb","intensity":-1})").find("its light 'a b' has"),
            std::string::npos);
  const std::string lost = R"({"name":"hol\nder","extensions":{"KHR_lights_punctual":{"light":7}}})";
  EXPECT_NE(refusal(R"({"type":"point"})", lost).find("node 'hol der' refers"), std::string::npos);
}

TEST(GltfLight, NodesThatNameNoLightAreRefused) {
  for (const int index : {1, -1, 2147483647})
    EXPECT_NE(refusal(R"({"type":"point"})", node(index)).find("a light that the file does not hold"),
              std::string::npos);
  const std::string text = R"({"name":"n","extensions":{"KHR_lights_punctual":{"light":"first"}}})";
  EXPECT_NE(refusal(R"({"type":"point"})", text).find("a light that the file does not hold"),
            std::string::npos);
}

TEST(GltfLight, ANodeThatIsFlatHasNoDirection) {
  const std::string flat = node(0, R"(,"scale":[1,1,0])"), away = node(0, R"(,"translation":[1e6,0,0])");
  EXPECT_NE(refusal(R"({"type":"directional"})", flat).find("has no direction"), std::string::npos);
  EXPECT_NE(refusal(R"({"type":"spot","spot":{}})", flat).find("has no direction"), std::string::npos);
  EXPECT_EQ(refusal(R"({"type":"point"})", flat), "") << "a point shines all around";
  EXPECT_NE(refusal(R"({"type":"point"})", away).find("farther than 100 km"), std::string::npos);
}

// How many are drawn, the scene says.
TEST(GltfLight, ThousandsAreRead) {
  std::string lights = R"({"type":"point"})", nodes = node(0);
  for (int i = 1; i < 3000; ++i) {
    lights += R"(,{"type":"point"})";
    nodes += "," + node(i);
  }
  EXPECT_EQ(lights_of(lit(lights, nodes)).size(), 3000u);
}

}  // namespace
}  // namespace fulcrum
