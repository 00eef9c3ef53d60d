#include "engine/scenario/variant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

namespace fulcrum::scenario {
namespace {

std::vector<Checkpoint> five() {
  std::vector<Checkpoint> list;
  for (int i = 0; i < 5; ++i) {
    Checkpoint& checkpoint = list.emplace_back();
    checkpoint.name = std::string(1, static_cast<char>('a' + i));
    checkpoint.position = Vec3(i, 0, 0);
    checkpoint.written = static_cast<std::size_t>(i);
  }
  list[4].follow = {Vec3(4, 1, 0)};
  return list;
}

std::string names(const std::vector<Checkpoint>& list) {
  std::string all;
  for (const Checkpoint& checkpoint : list) all += checkpoint.name;
  return all;
}

TEST(Variant, WithoutOneNothingChanges) {
  std::vector<Checkpoint> list = five();
  vary(list, {}, Order::any, 7);
  EXPECT_EQ(names(list), "abcde");
  EXPECT_EQ(list[3].position, Vec3(3, 0, 0));
}

TEST(Variant, IsTheSameForTheSameSeed) {
  const VariantDesc variant{.shuffle = true, .pick = 3, .spread = 0.01};
  std::set<std::string> seen;
  for (std::int64_t seed = 0; seed < 50; ++seed) {
    std::vector<Checkpoint> one = five(), again = five();
    vary(one, variant, Order::any, seed);
    vary(again, variant, Order::any, seed);
    ASSERT_EQ(names(one), names(again));
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].position, again[i].position);
    seen.insert(names(one));
  }
  EXPECT_GT(seen.size(), 30u);  // of 60 that there are
}

// Each of the 120 orders about as often as any other: 12 000 seeds, 100 each, within five standard
// deviations.
TEST(Variant, EveryOrderIsAsLikely) {
  std::map<std::string, int> count;
  for (std::int64_t seed = 0; seed < 12000; ++seed) {
    std::vector<Checkpoint> list = five();
    vary(list, {.shuffle = true}, Order::any, seed);
    ++count[names(list)];
  }
  EXPECT_EQ(count.size(), 120u);
  for (const auto& [order, times] : count) EXPECT_NEAR(times, 100, 50) << order;
}

// Of four that have to be, two: six choices, each in its order, and the optional one stays.
TEST(Variant, EveryChoiceIsAsLikely) {
  std::map<std::string, int> count;
  for (std::int64_t seed = 0; seed < 6000; ++seed) {
    std::vector<Checkpoint> list = five();
    list[2].optional = true;
    vary(list, {.pick = 2}, Order::any, seed);
    ++count[names(list)];
  }
  EXPECT_EQ(count.size(), 6u);
  for (const auto& [choice, times] : count) {
    EXPECT_EQ(choice.size(), 3u) << choice;
    EXPECT_NE(choice.find('c'), choice.npos) << choice;
    EXPECT_TRUE(std::ranges::is_sorted(choice)) << choice;
    EXPECT_NEAR(times, 1000, 150) << choice;
  }
}

// Who comes after one that is not there comes after what that comes after.
TEST(Variant, AChainGoesOnWithoutALinkThatIsNotPicked) {
  int seen = 0;
  for (std::int64_t seed = 0; seed < 200; ++seed) {
    std::vector<Checkpoint> list = five();
    for (std::size_t i = 1; i < 5; ++i) list[i].after = list[i - 1].name;
    vary(list, {.pick = 2}, Order::any, seed);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].after, "");
    EXPECT_EQ(list[1].after, list[0].name);
    seen += list[1].written - list[0].written > 1 ? 1 : 0;
  }
  EXPECT_GT(seen, 50);
}

// In the order given an optional one at the end would never be asked for.
TEST(Variant, TheLastOfAnOrderIsOneThatHasToBe) {
  for (std::int64_t seed = 0; seed < 200; ++seed) {
    std::vector<Checkpoint> list = five();
    list[1].optional = list[3].optional = true;
    vary(list, {.shuffle = true, .pick = seed % 3}, Order::given, seed);
    EXPECT_FALSE(list.back().optional) << names(list);
    EXPECT_EQ(std::ranges::count(list, true, &Checkpoint::optional), 2);
  }
}

// In a ball about where it was, as often in any eighth of it, and a line goes along.
TEST(Variant, SpreadsWithinItsRadius) {
  std::array<int, 8> octants{};
  double farthest = 0;
  for (std::int64_t seed = 0; seed < 4000; ++seed) {
    std::vector<Checkpoint> list = five();
    vary(list, {.spread = 0.01}, Order::any, seed);
    const Vec3 way = list[4].position - Vec3(4, 0, 0);
    farthest = std::max(farthest, way.norm());
    EXPECT_LT((list[4].follow[0] - Vec3(4, 1, 0) - way).norm(), 1e-12);
    ++octants[static_cast<std::size_t>((way.x() > 0 ? 1 : 0) + (way.y() > 0 ? 2 : 0) +
                                       (way.z() > 0 ? 4 : 0))];
  }
  EXPECT_LE(farthest, 0.01);
  EXPECT_GT(farthest, 0.0099);
  for (const int count : octants) EXPECT_NEAR(count, 500, 110);
}

}  // namespace
}  // namespace fulcrum::scenario
