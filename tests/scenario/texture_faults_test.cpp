#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/scenario/assemble.h"
#include "engine/scenario/surfaces.h"
#include "tests/assets/textured.h"
#include "tests/scenario/box_glb.h"
#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

// As what is wrong with a model itself: by its name, at its line, all of them at once.
TEST(AssembleVisual, NamesEveryModelWhoseTexturesCannotBeUsed) {
  const Folder folder;
  fulcrum::test::Textured torn(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})");
  torn.file.appended[32 + 20] ^= std::byte{0x41};  // the picture comes after 32 bytes of coordinates
  const auto bytes = torn.file.bytes();
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  folder.write("scenarios/peg/block.glb", text);
  folder.write("scenarios/peg/coarse.glb", text);
  folder.write("scenarios/peg/peg.glb", box_glb({-0.005F, 0.0F, -0.005F}, {0.005F, 0.04F, 0.005F}));
  const std::vector<std::string> overrides{"models.peg.drawn=coarse.glb"};
  const auto scenario = load_scenario_text(
      std::string(kScenario) + "materials: {stel: {base_colour: [1, 0, 0]}}\n", folder.peg(), overrides);
  ASSERT_TRUE(scenario) << to_text(scenario.faults());
  const auto models = load_models(*scenario);
  ASSERT_TRUE(models) << to_text(models.faults());
  const auto visual = assemble_visual(*scenario, *models, {});
  ASSERT_FALSE(visual);
  ASSERT_EQ(visual.faults().size(), 3u) << to_text(visual.faults());
  EXPECT_TRUE(visual.faults()[0].text().starts_with(
      "scenario.yaml:6:17: model 'block': 'block.glb': the texture grain cannot be used: it is damaged ("))
      << to_text(visual.faults());
  EXPECT_TRUE(visual.faults()[1].text().starts_with(
      "--set models.peg.drawn=coarse.glb: model 'peg': 'coarse.glb': the texture grain cannot be used: "))
      << to_text(visual.faults());
  EXPECT_EQ(visual.faults()[2].line, 20);
}

// Smaller sizes are a third more.
TEST(Textures, AreCountedInAllTheirSizes) {
  const std::uint32_t side = 64;
  const std::uint64_t largest = std::uint64_t{4} * side * side;
  Model model;
  model.images.push_back({"grain", fulcrum::test::png_of(side, side, PNG_FORMAT_RGB,
                                                         std::vector<std::uint8_t>(3 * side * side, 9))});
  model.materials.emplace_back().detail.emplace().base_colour.emplace();
  model.parts.emplace_back();
  const auto refused = [&](std::uint64_t most) {
    render::VisualDesc desc;
    return add_materials(desc, model, most);
  };
  const auto too_many = refused(largest);
  ASSERT_TRUE(too_many);
  EXPECT_TRUE(
      too_many->sentence.starts_with("the textures of the scene take more than 1 GB with this one, grain"))
      << too_many->sentence;
  EXPECT_TRUE(refused(largest / 3 * 4 - 1));
  EXPECT_FALSE(refused(largest / 3 * 4));
}

}  // namespace
}  // namespace fulcrum::scenario::test
