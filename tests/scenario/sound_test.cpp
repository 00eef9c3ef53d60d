// The key `sound`: named it is there, unnamed it is not, and what is wrong with it is refused.

#include <gtest/gtest.h>

#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

const std::string kNamed =
    std::string(kScenario) + "sound: {gain: 0.5, pitch: 8, slide: 0, material: steel}\n";

TEST(SoundKey, IsThereWhereItIsNamedAlone) {
  const Folder folder;
  const auto silent = load_scenario_text(kScenario, folder.peg(), {});
  ASSERT_TRUE(silent);
  EXPECT_FALSE(silent->sound);
  EXPECT_TRUE(silent->impact_materials.empty());
  EXPECT_FALSE(silent->texts.files.contains("materials/steel.yaml"));

  const auto named = load_scenario_text(kNamed, folder.peg(), {});
  ASSERT_TRUE(named);
  ASSERT_TRUE(named->sound);
  EXPECT_EQ(named->sound->gain, 0.5);
  EXPECT_EQ(named->sound->pitch, 8);
  EXPECT_EQ(named->sound->slide, 0);
  EXPECT_EQ(named->impact_materials.at("steel").frequency_Hz, 35);
  EXPECT_TRUE(named->texts.files.contains("materials/steel.yaml"));  // so that a tape has it

  const auto plain = load_scenario_text(std::string(kScenario) + "sound: {}\n", folder.peg(), {});
  ASSERT_TRUE(plain);
  ASSERT_TRUE(plain->sound);
  EXPECT_EQ(plain->sound->material, "steel");
}

TEST(SoundKey, IsRefusedWhereItIsWrong) {
  const Folder folder;
  const auto faults = [&](const char* override) { return faults_of(folder, kNamed, {override}); };
  EXPECT_NE(faults("sound.gain=1.5").find("gain"), std::string::npos);
  EXPECT_NE(faults("sound.pitch=0").find("pitch"), std::string::npos);
  EXPECT_NE(faults("sound.slide=-1").find("slide"), std::string::npos);
  EXPECT_NE(faults("sound.pich=2").find("did you mean 'sound.pitch'"), std::string::npos)
      << faults("sound.pich=2");
  EXPECT_NE(faults("sound.material=steal").find("materials/steal.yaml"), std::string::npos);
  EXPECT_NE(faults("sound.material=steal").find("'steel'"), std::string::npos)
      << faults("sound.material=steal");
  EXPECT_NE(faults_of(folder, std::string(kScenario) + "sound: loud\n"), "");
}

}  // namespace
}  // namespace fulcrum::scenario::test
