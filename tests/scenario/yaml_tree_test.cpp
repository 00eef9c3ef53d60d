#include "engine/scenario/yaml_tree.h"

#include <gtest/gtest.h>

#include <string>

namespace fulcrum::scenario {
namespace {

std::string fault_of(std::string_view text) {
  const auto root = parse_yaml(text, "f");
  return root ? "none" : to_text(root.faults());
}

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

// What the parser stumbles over stands far from the slip.
TEST(YamlTree, NamesSlipsOfTheHand) {
  const auto said = [](const char* text) {
    const auto root = parse_yaml(text, "f");
    return root ? std::string("read") : to_text(root.faults());
  };
  EXPECT_EQ(said("a: [1, 2\nb: 3\nc: 4\n"), "f:1:4: this '[' is not closed: write ']' where the list ends");
  EXPECT_EQ(said("a: {x: [1, 2], y: 3\nb: 3\n"),
            "f:1:4: this '{' is not closed: write '}' where the mapping ends");
  EXPECT_EQ(said("a: [\"[\", '[', 3 # [\n  , 4\nb: 3\n"),
            "f:1:4: this '[' is not closed: write ']' where the list ends");
  EXPECT_EQ(said("a:\n\tb: 1\n"),
            "f:2:1: this line is indented with a tab, which YAML does not allow: use spaces");
  EXPECT_EQ(said("title: a [ in text\nb: 1\n"), "read");
  EXPECT_EQ(said("title: a [ in text\nb: c: d\n").find("not closed"), std::string::npos);
}

TEST(YamlTree, KnowsWhereEverythingStands) {
  const auto root = parse_yaml("a: 1\nb:\n  - x\n  - {c: \"2\"}\n", "f");
  ASSERT_TRUE(root);
  ASSERT_EQ(root->kind, Node::Kind::mapping);
  EXPECT_EQ(root->mark.place().text(), "f:1:1");
  const Node& b = root->find("b")->value;
  EXPECT_EQ(root->find("b")->key_mark.place().text(), "f:2:1");
  ASSERT_EQ(b.kind, Node::Kind::list);
  EXPECT_EQ(b.mark.place().text(), "f:3:3");
  EXPECT_EQ(b.items[0].text, "x");
  EXPECT_EQ(b.items[0].mark.place().text(), "f:3:5");
  const Node& c = b.items[1].find("c")->value;
  EXPECT_EQ(c.mark.place().text(), "f:4:9");
  EXPECT_TRUE(c.quoted);
  EXPECT_FALSE(root->find("a")->value.quoted);
  EXPECT_EQ(root->find("missing"), nullptr);
}

TEST(YamlTree, AnEmptyTextIsNull) {
  for (const char* text : {"", "\n", "# nothing\n", "~"}) {
    const auto root = parse_yaml(text, "f");
    ASSERT_TRUE(root) << text;
    EXPECT_EQ(root->kind, Node::Kind::null) << text;
  }
}

TEST(YamlTree, RefusesAKeyGivenTwice) {
  EXPECT_EQ(fault_of("a: 1\nb: 2\na: 3\n"),
            "f:3:1: key 'a' is already given on line 1; remove one of the two");
  EXPECT_EQ(fault_of("x: {a: 1, a: 2}"), "f:1:11: key 'a' is already given on line 1; remove one of the two");
}

TEST(YamlTree, RefusesAnchorsAndAliases) {
  EXPECT_EQ(fault_of("a: &x 1\nb: *x\n"),
            "f:1:4: anchor '&x' is not supported; write the value out where it is needed");
  EXPECT_TRUE(fault_of("b: *x\n").starts_with("f:1:4: ")) << fault_of("b: *x\n");
}

TEST(YamlTree, RefusesTags) {
  EXPECT_EQ(fault_of("a: !!int 1\n"),
            "f:1:4: tag 'tag:yaml.org,2002:int' is not supported; types follow from the key, so remove it");
  EXPECT_EQ(fault_of("a: !thing {b: 1}\n"),
            "f:1:4: tag '!thing' is not supported; types follow from the key, so remove it");
}

TEST(YamlTree, RefusesASecondDocument) {
  EXPECT_EQ(
      fault_of("a: 1\n---\nb: 2\n"),
      "f:2:1: a second document starts here; a file holds one, so remove the '---' and what follows it");
  EXPECT_EQ(fault_of("---\na: 1\n"), "none");
}

TEST(YamlTree, RefusesKeysThatAreNotText) {
  EXPECT_EQ(fault_of("? [1, 2]\n: 3\n"),
            "f:1:3: a list or mapping stands where a key should, which is plain text; is a closing bracket "
            "missing?");
  EXPECT_TRUE(fault_of(": 3\n").find("a key is missing") != std::string::npos) << fault_of(": 3\n");
}

TEST(YamlTree, PointsAtBrokenSyntax) {
  EXPECT_TRUE(fault_of("a: [1, 2\nb: 3\n").starts_with("f:")) << fault_of("a: [1, 2\nb: 3\n");
  EXPECT_TRUE(fault_of("a: 1\n b: 2\n").find("this is not valid YAML: ") != std::string::npos);
}

// The parser's own messages repeat the character that it does not know.
TEST(YamlTree, SaysWhatIsBrokenOnOneLine) {
  EXPECT_EQ(fault_of("a: \"\\\x1b[2J\""), "f:1:7: this is not valid YAML: unknown escape character:  ");
}

// A file from elsewhere must cost neither the stack, nor the memory, nor minutes.
TEST(YamlTree, HoldsAgainstHostileFiles) {
  EXPECT_NE(fault_of(repeated("[", 100'000)), "none");
  EXPECT_NE(fault_of(repeated("{a: ", 100'000)), "none");
  EXPECT_NE(fault_of(repeated("- ", 100'000)), "none");
  EXPECT_NE(fault_of(repeated("? ", 100'000)), "none");
  EXPECT_NE(fault_of(repeated("!", 100'000)), "none");
  EXPECT_NE(fault_of(std::string(kMaxTextBytes + 1, 'a')), "none");
  EXPECT_NE(fault_of(repeated("- a\n", kMaxNodes + 1)), "none");
  std::string keys;
  for (std::size_t i = 0; i <= kMaxKeys; ++i) keys.append(1, 'k').append(std::to_string(i)).append(": 1\n");
  EXPECT_NE(fault_of(keys).find("more than 1000 keys"), std::string::npos);
  EXPECT_EQ(fault_of(repeated("[", kMaxDepth) + repeated("]", kMaxDepth)), "none");
  EXPECT_NE(fault_of(repeated("[", kMaxDepth + 1) + repeated("]", kMaxDepth + 1)).find("nested deeper"),
            std::string::npos);
}

}  // namespace
}  // namespace fulcrum::scenario
