// Damaged scenarios. The reference is the reader's promise: any text gives a scenario or at least one fault,
// each fault with a sentence and a place inside the text, and the same text gives the same answer. Run it
// under ASan and UBSan.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

constexpr int kMutants = 3000;

class Mutator {
public:
  explicit Mutator(std::vector<std::string> seeds) : seeds_(std::move(seeds)) {}

  std::string next() {
    std::string text = seeds_[below(seeds_.size())];
    for (std::size_t i = 0; i <= below(4); ++i) change(text);
    return text;
  }

private:
  // The generator's own arithmetic, so that every standard library makes the same mutants.
  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

  void change(std::string& text) {
    static const std::vector<std::string> kTokens{"&a ",
                                                  "*a",
                                                  "!!int ",
                                                  "---\n",
                                                  "...\n",
                                                  "\"",
                                                  "'",
                                                  "{",
                                                  "}",
                                                  "[",
                                                  "]",
                                                  ": ",
                                                  "- ",
                                                  "? ",
                                                  "| ",
                                                  "> ",
                                                  "#",
                                                  ",",
                                                  ".nan",
                                                  ".inf",
                                                  "-.inf",
                                                  "1e999",
                                                  "-0",
                                                  "0x10",
                                                  "9223372036854775808",
                                                  "~",
                                                  "null",
                                                  "true",
                                                  "\t",
                                                  "\r\n",
                                                  "%",
                                                  "../",
                                                  "/etc/passwd",
                                                  "\xff\xfe",
                                                  "\xc3\x28",
                                                  "fulcrum: 1\n",
                                                  "<<: ",
                                                  "a: &a [*a]\n",
                                                  "radius: 0\n"};
    const std::size_t at = below(text.size());
    const std::size_t length = below(1 + std::min<std::size_t>(text.size() - at, 24));
    switch (below(7)) {
      case 0:
        if (!text.empty()) text[at] = static_cast<char>(below(256));
        return;
      case 1:
        text.erase(at, length);
        return;
      case 2:
        text.insert(at, kTokens[below(kTokens.size())]);
        return;
      case 3:
        text.insert(below(text.size()), text.substr(at, length));
        return;
      case 4:
        text.replace(at, length, kTokens[below(kTokens.size())]);
        return;
      case 5:
        text.resize(at);
        return;
      default: {  // a line taken elsewhere
        const std::size_t begin = text.rfind('\n', at) == text.npos ? 0 : text.rfind('\n', at) + 1;
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = begin < end ? text.substr(begin, end - begin) + "\n" : "\n";
        text.insert(below(text.size()), line);
      }
    }
  }

  std::vector<std::string> seeds_;
  std::mt19937 random_{20240607};
};

std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Mutation, OfAScenarioGivesAScenarioOrFaults) {
  const Folder folder;
  const auto piping =
      std::filesystem::path(FULCRUM_SOURCE_DIR) / "content" / "scenarios" / "piping" / "scenario.yaml";
  const std::string struck = replaced(
      kScenario,
      "contact:", "impact: {retreat: 0.004}\nimpact_vibration: {render: torque, voices: 4}\ncontact:");
  Mutator mutator({kScenario, struck, file_text(piping)});
  int read = 0;
  for (int i = 0; i < kMutants; ++i) {
    const std::string text = mutator.next();
    const SourceTexts texts{"scenario.yaml",
                            {{"scenario.yaml", text},
                             {"sure.yaml", kHandPath},
                             {"devices/test_arm.yaml", kDevice},
                             {"materials/steel.yaml", kMaterial}}};
    const auto scenario = load_scenario_texts(texts, folder.peg());
    if (scenario) {
      ++read;
      ASSERT_TRUE(scenario->tool.X_WM_start.is_finite());
      ASSERT_GE(scenario->checkpoints.size(), 1u);
      continue;
    }
    ASSERT_FALSE(scenario.faults().empty()) << text;
    const auto lines = static_cast<int>(std::ranges::count(text, '\n') + std::ranges::count(text, '\r')) + 2;
    for (const Fault& fault : scenario.faults()) {
      ASSERT_FALSE(fault.sentence.empty()) << text;
      ASSERT_FALSE(fault.file.empty()) << text;
      ASSERT_EQ(fault.text().find('\n'), std::string::npos) << fault.text();
      if (fault.file == "scenario.yaml") {
        ASSERT_GE(fault.line, 1) << fault.text();
        ASSERT_LE(fault.line, lines) << fault.text();
        ASSERT_GE(fault.column, 1) << fault.text();
      }
    }
  }
  EXPECT_GT(read, 0) << "no mutant survived: the mutations are too coarse to test anything behind the parser";
  EXPECT_LT(read, kMutants / 2);
}

TEST(Mutation, OfOverridesGivesAScenarioOrFaults) {
  const Folder folder;
  Mutator mutator({"contact.stiffness=5000", "velocity_estimator={name: low_pass, cutoff_Hz: 20}",
                   "checkpoints.0.position=[0, 1, 2]", "hands.sure.path=sure.yaml"});
  for (int i = 0; i < kMutants / 3; ++i) {
    const auto scenario =
        load_scenario_text(kScenario, folder.peg(), std::vector<std::string>{mutator.next()});
    ASSERT_TRUE(scenario || !scenario.faults().empty());
  }
}

TEST(Mutation, OfTheFilesItNamesGivesAScenarioOrFaults) {
  const Folder folder;
  Mutator paths({kHandPath});
  Mutator devices({kDevice});
  Mutator materials({kMaterial});
  const std::string scenario_text = replaced(kScenario, "contact:", "impact_vibration: {}\ncontact:");
  for (int i = 0; i < kMutants / 3; ++i) {
    const SourceTexts texts{"scenario.yaml",
                            {{"scenario.yaml", scenario_text},
                             {"sure.yaml", paths.next()},
                             {"devices/test_arm.yaml", devices.next()},
                             {"materials/steel.yaml", materials.next()}}};
    const auto scenario = load_scenario_texts(texts, folder.peg());
    ASSERT_TRUE(scenario || !scenario.faults().empty());
  }
}

}  // namespace
}  // namespace fulcrum::scenario::test
