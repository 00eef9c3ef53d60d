#include "engine/scenario/write_back.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {
namespace {

std::string changed(std::string_view text, const NumberChange& change) {
  const auto written = written_back(text, "a.yaml", std::vector{change});
  return written ? *written : "refused: " + to_text(written.faults());
}

TEST(WriteBack, ChangesNumbersWhereTheyStand) {
  EXPECT_EQ(changed("a: 1   # one\nb: 2\n", {"a", {1.5}}), "a: 1.5   # one\nb: 2\n");
  EXPECT_EQ(changed("p: [0.1 ,  0.20,0.3]  # [there]\n", {"p", {0.1, 0.25, -3}}),
            "p: [0.1 ,  0.25,-3]  # [there]\n");
  EXPECT_EQ(changed("p:\n  - 1 # x\n  - 2\n  - 3", {"p", {1, 2, 7}}), "p:\n  - 1 # x\n  - 2\n  - 7");
  EXPECT_EQ(
      changed("list:\n  - {n: a, p: [1, 2,\n      3]}\n  - {n: b, p: [1, 2, 3]}\n", {"list.1.p", {1, 2, 4}}),
      "list:\n  - {n: a, p: [1, 2,\n      3]}\n  - {n: b, p: [1, 2, 4]}\n");
  EXPECT_EQ(changed("\xc3\xa4: {\xc3\xb6: 1, x: 2}\n", {"\xc3\xa4.x", {3}}),
            "\xc3\xa4: {\xc3\xb6: 1, x: 3}\n");
  EXPECT_EQ(changed("a: 1\r\nb: 2\r\n", {"b", {3}}), "a: 1\r\nb: 3\r\n");
}

TEST(WriteBack, WhatIsTheSameStaysAsItWasWritten) {
  EXPECT_EQ(changed("p: [1e-3, 0.50, +2]\n", {"p", {0.001, 0.5, 2.000001}}), "p: [1e-3, 0.50, +2]\n");
  EXPECT_EQ(changed("a: 0\n", {"a", {-1e-9}}), "a: 0\n");
}

TEST(WriteBack, AddsWhatIsNotThere) {
  EXPECT_EQ(changed("m: {n: x, r: y}\n", {"m.p", {1, 2, 3}}), "m: {n: x, p: [1, 2, 3], r: y}\n");
  EXPECT_EQ(changed("m: {n: x}\n", {"m.p", {1}}), "m: {p: 1, n: x}\n");
  EXPECT_EQ(changed("l:\n  - n: x\n    r: y\n", {"l.0.p", {1}}), "l:\n  - p: 1\n    n: x\n    r: y\n");
  EXPECT_EQ(changed("v: 1\na: 2", {"t.start.position", {1, 2, 3}}),
            "v: 1\na: 2\nt: {start: {position: [1, 2, 3]}}\n");
}

TEST(WriteBack, RefusesWhatIsNoNumber) {
  EXPECT_EQ(changed("a: \"1\"\n", {"a", {2}}),
            "refused: a.yaml:1:4: 'a' cannot be written here; change it by hand to 2");
  EXPECT_EQ(changed("p: [1, 2]\n", {"p", {1, 2, 3}}),
            "refused: a.yaml:1:4: 'p' cannot be written here; change it by hand to [1, 2, 3]");
  EXPECT_EQ(changed("l: [{p: 1}]\n", {"l.4.p", {2}}),
            "refused: a.yaml:1:4: 'l.4.p' cannot be written here; change it by hand to 2");
  EXPECT_EQ(changed("a: &x 1\n", {"a", {2}}).substr(0, 8), "refused:");
}

TEST(WriteBack, SpeaksOfTheTextThatThereIs) {
  EXPECT_EQ(changed("a: 1\n...\n", {"b", {2}}),
            "refused: a.yaml: cannot be written in this text; change it by hand: b to 2");
}

// Every path to a number, or to a list of numbers.
void find_numbers(const Node& node, const std::string& path,
                  std::vector<std::pair<std::string, std::size_t>>& found) {
  const auto is_number = [](const Node& one) {
    char* end = nullptr;
    std::strtod(one.text.c_str(), &end);
    return one.kind == Node::Kind::scalar && !one.quoted && !one.text.empty() && *end == 0;
  };
  if (is_number(node)) found.emplace_back(path, 1);
  if (node.kind == Node::Kind::list && node.items.size() >= 2 && std::ranges::all_of(node.items, is_number)) {
    found.emplace_back(path, node.items.size());
    return;
  }
  for (std::size_t i = 0; i < node.items.size(); ++i)
    find_numbers(node.items[i], path + (path.empty() ? "" : ".") + std::to_string(i), found);
  for (const NodeEntry& entry : node.entries)
    find_numbers(entry.value, path + (path.empty() ? "" : ".") + entry.key, found);
}

// A text as what stands between the values, which are what numbers are made of.
std::pair<std::vector<std::string>, std::vector<std::string>> taken_apart(const std::string& text) {
  std::vector<std::string> between(1), values;
  bool in_value = false;
  for (const char c : text) {
    const bool is_of_value = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+';
    if (is_of_value != in_value) (is_of_value ? values : between).emplace_back();
    (is_of_value ? values : between).back() += c;
    in_value = is_of_value;
  }
  return {between, values};
}

// Fifty edits of every shipped scenario, each compared with the text before it: as many words differ as
// numbers were changed, and what stands between them is the same.
TEST(WriteBack, FiftyEditsOfEachShippedScenarioShowNothingElse) {
  std::mt19937 random(5);
  int files = 0;
  for (const auto& folder : std::filesystem::directory_iterator(FULCRUM_SOURCE_DIR "/content/scenarios")) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      if (file.path().extension() != ".yaml") continue;
      std::ifstream stream(file.path());
      std::stringstream read;
      read << stream.rdbuf();
      const std::string original = read.str();
      const auto root = parse_yaml(original, "it");
      ASSERT_TRUE(root);
      std::vector<std::pair<std::string, std::size_t>> places;
      find_numbers(*root, {}, places);
      ASSERT_FALSE(places.empty());
      ++files;
      std::string text = original;
      for (int edit = 0; edit < 50; ++edit) {
        const auto& [path, count] = places[random() % places.size()];
        NumberChange change{path, {}};
        for (std::size_t i = 0; i < count; ++i)
          change.numbers.push_back(100 + static_cast<double>(random() % 1000000) / 1e5);
        const auto written = written_back(text, "it", std::vector{change});
        ASSERT_TRUE(written) << file.path() << ": " << to_text(written.faults());
        const auto [between, values] = taken_apart(text);
        const auto [between_now, values_now] = taken_apart(*written);
        ASSERT_EQ(between, between_now) << path;
        ASSERT_EQ(values.size(), values_now.size());
        std::size_t differ = 0;
        for (std::size_t i = 0; i < values.size(); ++i) differ += values[i] != values_now[i] ? 1 : 0;
        ASSERT_EQ(differ, count) << path;
        text = *written;
      }
    }
  }
  EXPECT_GT(files, 8);
}

}  // namespace
}  // namespace fulcrum::scenario
