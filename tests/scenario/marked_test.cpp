#include "engine/scenario/marked.h"

#include <gtest/gtest.h>

namespace fulcrum::scenario {
namespace {

Model marked(std::initializer_list<std::pair<const char*, const char*>> marks) {
  Model model;
  for (const auto& [role, material] : marks) {
    ModelPart& part = model.parts.emplace_back();
    part.name = "object " + std::to_string(model.parts.size());
    part.marked_role = role;
    part.marked_material = material;
  }
  return model;
}

TEST(Marked, AreThoseOfTheObjectsEachOnce) {
  const Model model = marked(
      {{"scene", "steel"}, {"", "wood"}, {"tool", ""}, {"scene", ""}, {"scene", "steel"}, {"decor", ""}});
  const std::vector<ObjectMark> expected{
      {ModelRole::scene, "steel"}, {ModelRole::tool, ""}, {ModelRole::scene, ""}, {ModelRole::decor, ""}};
  EXPECT_EQ(marks_of(model), expected);
}

TEST(Marked, AMaterialIsOfWhatIsTouchedAlone) {
  EXPECT_EQ(marks_of(marked({{"tool", "steel"}})), (std::vector<ObjectMark>{{ModelRole::tool, ""}}));
}

TEST(Marked, ThoseAreTakenThatAreMarkedSo) {
  Model model = marked({{"scene", "steel"}, {"", ""}, {"scene", ""}, {"scene", "steel"}, {"tool", ""}});
  Model plain = model;
  take_marked(model, ModelRole::scene, "steel");
  ASSERT_EQ(model.parts.size(), 2u);
  EXPECT_EQ(model.parts[1].name, "object 4");
  take_marked(plain, ModelRole::scene, "");
  ASSERT_EQ(plain.parts.size(), 1u);
  EXPECT_EQ(plain.parts[0].name, "object 3");
}

TEST(Marked, LightsAreTakenAsObjectsAre) {
  Model model = marked({{"scene", ""}, {"tool", ""}});
  for (const char* role : {"", "tool", "scene"}) model.lights.emplace_back().marked_role = role;
  take_marked(model, ModelRole::tool, "");
  ASSERT_EQ(model.lights.size(), 1u);
  EXPECT_EQ(model.lights[0].marked_role, "tool");
  model.lights[0].name = "lamp";
  model.lights[0].marked_role = "tol";
  EXPECT_EQ(refuse_marked(model, ModelRole::tool, ""),
            "has an object 'lamp' that is marked with the role 'tol'; did you mean 'tool'?");
}

TEST(Marked, WithoutMarksItSaysWhichBoxIsToBeTicked) {
  EXPECT_EQ(refuse_marked(marked({{"", ""}}), ModelRole::scene, ""),
            "has no object with a custom property 'fulcrum_role': mark them in the modelling program, and in "
            "Blender tick Include > Custom Properties when exporting");
}

TEST(Marked, AWordThatIsNoRoleIsToldWithItsObject) {
  EXPECT_EQ(refuse_marked(marked({{"scene", ""}, {"tol", ""}}), ModelRole::scene, ""),
            "has an object 'object 2' that is marked with the role 'tol'; did you mean 'tool'?");
}

TEST(Marked, AMarkThatNoneHasIsToldBesideThoseThereAre) {
  EXPECT_EQ(
      refuse_marked(marked({{"scene", "steel"}, {"tool", ""}}), ModelRole::scene, ""),
      "has no object marked with the role 'scene' and no material; some are marked with the role 'scene' "
      "and the material 'steel'; others are marked with the role 'tool'");
  EXPECT_EQ(refuse_marked(marked({{"scene", "steel"}}), ModelRole::scene, "steel"), "");
}

}  // namespace
}  // namespace fulcrum::scenario
