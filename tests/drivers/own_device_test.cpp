// Which device a run goes on with, by hand for each case.

#include "drivers/own_device.h"

#include <gtest/gtest.h>

namespace fulcrum::test {
namespace {

struct Plugged {
  std::string serial, port;
  std::string node = port;  // what tells two places apart here
};
using Places = std::vector<Plugged>;

// Nodes of what is left, each followed by a space.
std::string kept(OwnDevice& own, Places places) {
  own.keep_own(places);
  std::string nodes;
  for (const Plugged& place : places) nodes += place.node + " ";
  return nodes;
}

OwnDevice taken(const Places& all, std::size_t mine = 0) {
  OwnDevice own;
  own.be(all[mine], all);
  return own;
}

TEST(OwnDevice, ARunThatHasNoneYetMayTakeAny) {
  OwnDevice own;
  EXPECT_EQ(kept(own, {{"A", "1"}, {"", "2"}}), "1 2 ");
}

TEST(OwnDevice, ASerialNumberTellsAtWhateverPort) {
  OwnDevice own = taken({{"A", "1"}, {"B", "2"}});
  EXPECT_EQ(kept(own, {{"B", "2"}}), "");
  EXPECT_EQ(kept(own, {{"B", "1"}}), "") << "another one at its port";
  EXPECT_EQ(kept(own, {{"", "1"}}), "");
  EXPECT_EQ(kept(own, {{"B", "2"}, {"A", "7"}}), "7 ");
}

// As makers give them who give all the same.
TEST(OwnDevice, ASerialNumberThatTwoHaveTellsNothing) {
  OwnDevice own = taken({{"0", "1"}, {"0", "2"}}, 1);
  EXPECT_EQ(kept(own, {{"0", "1"}}), "");
  EXPECT_EQ(kept(own, {{"0", "1"}, {"0", "2"}}), "2 ");
}

TEST(OwnDevice, WithoutASerialNumberThePortTells) {
  OwnDevice own = taken({{"", "1"}, {"", "2"}});
  EXPECT_EQ(kept(own, {{"", "2"}}), "") << "it was there before";
  EXPECT_EQ(kept(own, {{"", "2"}, {"", "1"}}), "1 ");
}

TEST(OwnDevice, AloneItMayComeBackAtAnotherPort) {
  OwnDevice own = taken({{"", "1"}});
  EXPECT_EQ(kept(own, {}), "");
  EXPECT_EQ(kept(own, {{"", "3"}}), "3 ");
}

// The other one came during the run: it is there when the own one is first missed.
TEST(OwnDevice, WhatIsThereAtTheFirstLookIsAnother) {
  OwnDevice own = taken({{"", "1"}});
  EXPECT_EQ(kept(own, {{"", "2"}}), "");
  EXPECT_EQ(kept(own, {{"", "2"}}), "");
  EXPECT_EQ(kept(own, {{"", "2"}, {"", "3"}}), "3 ");
  own.be(Plugged{"", "3"}, Places{{"", "2"}, {"", "3"}});
  EXPECT_EQ(kept(own, {{"", "2"}, {"", "1"}}), "") << "both may be others";
}

TEST(OwnDevice, WhereNobodyCanTellNoneIsTaken) {
  OwnDevice own = taken({{"", "1"}});
  EXPECT_EQ(kept(own, {}), "");
  EXPECT_EQ(kept(own, {{"", "2"}, {"", "3"}}), "");
  EXPECT_EQ(kept(own, {{"", "2"}, {"", "1"}, {"", "3"}}), "1 ");
}

TEST(OwnDevice, OneDeviceMayHaveSeveralPlaces) {
  OwnDevice own = taken({{"", "1", "a"}, {"", "1", "b"}, {"", "2", "c"}}, 1);
  EXPECT_EQ(kept(own, {{"", "2", "c"}, {"", "1", "d"}, {"", "1", "e"}}), "d e ");
}

// A bus that tells neither: any of them, as there is no other way.
TEST(OwnDevice, WhereNothingIsKnownAllMayBeIt) {
  OwnDevice own = taken({{"", "", "a"}, {"", "", "b"}});
  EXPECT_EQ(kept(own, {{"", "", "b"}, {"", "", "c"}}), "b c ");
}

}  // namespace
}  // namespace fulcrum::test
