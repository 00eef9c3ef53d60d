// What Haply's service says and is told, against messages written down from its manual and against others
// that mean ill.

#include <gtest/gtest.h>

#include <limits>

#include "drivers/inverse3/service_messages.h"

namespace fulcrum::test {
namespace {

using inverse3::Chosen;
using inverse3::decode;
using inverse3::encode_force;

// As the manual of 3.4 prints it, shortened to what may matter.
constexpr const char* kInventory = R"({"inverse3":[{"device_id":"04BA","config":{"type":"inverse3",
  "device_info":{"minor_version":1,"major_version":7,"id":"04BA"},"handedness":"right"},
  "state":{"angular_position":{"a0":-69.31704,"a1":137.62952,"a2":19.832787},
  "cursor_position":{"x":0.07842738,"y":-0.14836666,"z":0.14297646},"mode":"idle"},
  "status":{"calibrated":true,"in_use":false,"power_supply":true,"ready":true,"started":true}}],
  "verse_grip":[{"device_id":"61548","config":{"port":"COM3","type":"verse_grip"},"state":{"button":true,"hall":0,
  "orientation":{"x":-0.5019531,"y":0.8632202,"z":-0.048095703,"w":-0.022338867}},"status":{"error":0}}]})";

std::string with_state(const std::string& state) {
  return R"({"inverse3":[{"device_id":"A","state":)" + state + "}]}";
}
std::string at(const std::string& x) {
  return with_state(R"({"cursor_position":{"x":)" + x + R"(,"y":0,"z":0}})");
}

TEST(Inverse3Messages, TheManualsExampleIsRead) {
  const auto says = decode(kInventory, std::nullopt);
  ASSERT_TRUE(says);
  EXPECT_EQ(says->of.arm, "04BA");
  EXPECT_EQ(says->of.handle, "61548");
  EXPECT_EQ(says->p_SH, Vec3(0.07842738, -0.14836666, 0.14297646));
  ASSERT_TRUE(says->q_SH);
  EXPECT_NEAR(says->q_SH->y(), 0.8632202, 1e-3);
  EXPECT_NEAR(says->q_SH->norm(), 1, 1e-12);
  EXPECT_EQ(says->buttons, 1u);
  EXPECT_TRUE(says->calibrated && says->powered);
  EXPECT_FALSE(says->since_3_5);
  EXPECT_EQ(says->unusable, "");
}

TEST(Inverse3Messages, AWirelessHandleHasThreeButtons) {
  const auto says = decode(
      R"({"session_id":7,"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0,"y":0,"z":0}}}],
      "wireless_verse_grip":[{"device_id":"W","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},
      "buttons":{"a":false,"b":true,"c":true}}}]})",
      std::nullopt);
  ASSERT_TRUE(says);
  EXPECT_TRUE(says->since_3_5);
  EXPECT_EQ(says->of.handle, "W");
  EXPECT_EQ(says->buttons, 6u);
}

TEST(Inverse3Messages, TheForceIsToldAsTheManualHasIt) {
  EXPECT_EQ(
      encode_force("049D", {0, -2, 1.5}, true),
      R"({"inverse3":[{"commands":{"set_cursor_force":{"vector":{"x":0.0,"y":-2.0,"z":1.5}}},"device_id":"049D"}]})");
  EXPECT_NE(encode_force("049D", {1, 0, 0}, false).find(R"("values":{"x":1.0)"), std::string::npos);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const Vec3& none : {Vec3(nan, 1, 1), Vec3(1, infinity, 1), Vec3(1, 1, -infinity)})
    EXPECT_NE(encode_force("A", none, true).find(R"({"x":0.0,"y":0.0,"z":0.0})"), std::string::npos);
}

TEST(Inverse3Messages, ANameIsQuoted) {
  const auto says = decode(
      R"({"inverse3":[{"device_id":"\"}]","state":{"cursor_position":{"x":0,"y":0,"z":0}}}]})", std::nullopt);
  ASSERT_TRUE(says);
  EXPECT_NE(encode_force(says->of.arm, Vec3::Zero(), true).find(R"("device_id":"\"}]")"), std::string::npos);
}

TEST(Inverse3Messages, OfTwoTheChosenOneIsRead) {
  const std::string two =
      R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0.1,"y":0,"z":0}}},
      {"device_id":"B","state":{"cursor_position":{"x":0.2,"y":0,"z":0}}}]})";
  EXPECT_EQ(decode(two, std::nullopt)->of.arm, "A");
  EXPECT_EQ(decode(two, Chosen{"B", ""})->p_SH.x(), 0.2);
  EXPECT_EQ(decode(two, Chosen{"C", ""})->of.arm, "") << "it is gone, and no other takes its place";
}

TEST(Inverse3Messages, AHandleThatComesLaterIsNotTaken) {
  EXPECT_FALSE(decode(kInventory, Chosen{"04BA", ""})->q_SH);
  EXPECT_FALSE(decode(kInventory, Chosen{"04BA", "another"})->q_SH);
}

TEST(Inverse3Messages, NonsenseIsRefused) {
  for (const std::string& bad : {std::string(),
                                 std::string("null"),
                                 std::string("[]"),
                                 std::string("7"),
                                 std::string("{"),
                                 std::string(kInventory).substr(0, 300),
                                 std::string("\xff\xfe{}"),

                                 std::string(R"({"inverse3":{}})"),
                                 std::string(R"({"inverse3":[7]})"),
                                 std::string(R"({"inverse3":[{}]})"),
                                 std::string(R"({"inverse3":[{"device_id":7}]})"),
                                 std::string(R"({"inverse3":[{"device_id":""}]})"),
                                 std::string(R"({"inverse3":[{"device_id":"A"}]})"),
                                 with_state("7"),
                                 with_state("{}"),
                                 with_state(R"({"cursor_position":[0,0,0]})"),
                                 with_state(R"({"cursor_position":{"x":0,"y":0}})"),
                                 at("NaN"),
                                 at("nan"),
                                 at("\"NaN\""),
                                 at("Infinity"),
                                 at("1e999"),
                                 at("null"),
                                 at("\"0.1\""),
                                 at("true"),
                                 at("1.5"),
                                 at("-1e300"),
                                 at("{}")})
    EXPECT_FALSE(decode(bad, std::nullopt)) << bad;
  ASSERT_TRUE(decode(at("0.1"), std::nullopt));
}

TEST(Inverse3Messages, AHandleThatSaysNonsenseSpoilsTheMessage) {
  const auto with_handle = [](const std::string& state) {
    return R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0,"y":0,"z":0}}}],
      "verse_grip":[{"device_id":"V","state":)" +
           state + "}]}";
  };
  for (const char* bad :
       {R"({"orientation":{"w":0,"x":0,"y":0,"z":0}})", R"({"orientation":{"w":2,"x":0,"y":0,"z":0}})",
        R"({"orientation":{"w":1e200,"x":1e200,"y":0,"z":0}})", R"({"orientation":[1,0,0,0]})",
        R"({"orientation":{"w":"1","x":0,"y":0,"z":0}})", R"({"button":1})", R"({"buttons":[true]})",
        R"({"buttons":{"a":"yes"}})"})
    EXPECT_FALSE(decode(with_handle(bad), std::nullopt)) << bad;
  const auto asleep = decode(with_handle("{}"), std::nullopt);
  ASSERT_TRUE(asleep);
  EXPECT_EQ(asleep->of.handle, "V");
  EXPECT_FALSE(asleep->q_SH);
}

TEST(Inverse3Messages, TwoOfOneNameAreNobody) {
  const std::string one = R"({"device_id":"A","state":{"cursor_position":{"x":0,"y":0,"z":0}}})";
  EXPECT_FALSE(decode(R"({"inverse3":[)" + one + "," + one + "]}", std::nullopt));
  EXPECT_FALSE(decode(R"({"inverse3":[)" + one + "," + one + "]}", Chosen{"A", ""}));
}

TEST(Inverse3Messages, WhatIsTooLongOrTooDeepIsRefused) {
  const std::string good = at("0.1");
  const auto padded = [&](std::size_t bytes) { return good + std::string(bytes - good.size(), ' '); };
  EXPECT_TRUE(decode(padded(65536), std::nullopt));
  EXPECT_FALSE(decode(padded(65537), std::nullopt));
  const auto nested = [&](std::size_t deep) {
    return R"({"more":)" + std::string(deep, '[') + std::string(deep, ']') + "," + good.substr(1);
  };
  EXPECT_TRUE(decode(nested(10), std::nullopt));
  for (const std::size_t deep : {20u, 1000u, 30000u})
    EXPECT_FALSE(decode(nested(deep), std::nullopt)) << deep;
  EXPECT_FALSE(decode(std::string(60000, '['), std::nullopt));
  EXPECT_FALSE(
      decode(R"({"inverse3":[{"device_id":")" + std::string(65, 'A') + good.substr(28), std::nullopt));
}

}  // namespace
}  // namespace fulcrum::test
