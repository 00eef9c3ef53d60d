// Joy-Cons by reports written by hand from "Nintendo Switch Reverse Engineering", and by its table of
// frequencies and amplitudes, which nobody here computed.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "drivers/joycon/joycon_pair.h"
#include "drivers/joycon/joycon_protocol.h"
#include "drivers/joycon/joycon_rumble.h"

namespace fulcrum::test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using joycon::JoyConProtocol;
using joycon::rumble_of;
using joycon::RumbleBytes;
using joycon::Side;

// Column "Amplitude" of rumble_data_table.md up to the last safe one, in the order of its rows.
constexpr double kAmplitudes[] = {
    0.000000, 0.007843, 0.011823, 0.014061, 0.016720, 0.019885, 0.023648, 0.028123, 0.033442, 0.039771,
    0.047296, 0.056246, 0.066886, 0.079542, 0.094592, 0.112491, 0.117471, 0.122671, 0.128102, 0.133774,
    0.139697, 0.145882, 0.152341, 0.159085, 0.166129, 0.173484, 0.181166, 0.189185, 0.197561, 0.206308,
    0.215442, 0.224982, 0.229908, 0.234943, 0.240087, 0.245345, 0.250715, 0.256206, 0.261816, 0.267549,
    0.273407, 0.279394, 0.285514, 0.291765, 0.298154, 0.304681, 0.311353, 0.318171, 0.325138, 0.332258,
    0.339534, 0.346969, 0.354566, 0.362331, 0.370265, 0.378372, 0.386657, 0.395124, 0.403777, 0.412619,
    0.421652, 0.430885, 0.440321, 0.449964, 0.459817, 0.469885, 0.480174, 0.490689, 0.501433, 0.512413,
    0.523633, 0.535100, 0.546816, 0.558790, 0.571027, 0.583530, 0.596307, 0.609365, 0.622708, 0.636344,
    0.650279, 0.664518, 0.679069, 0.693939, 0.709133, 0.724662, 0.740529, 0.756745, 0.773316, 0.790249,
    0.807554, 0.825237, 0.843307, 0.861772, 0.880643, 0.899928, 0.919633, 0.939771, 0.960348, 0.981378,
    1.002867};

TEST(JoyConRumble, AtRestIsThePublishedNeutral) {
  const RumbleBytes neutral{0x00, 0x01, 0x40, 0x40};
  for (const double frequency_Hz : {1.0, 41.0, 160.0, 233.0, 320.0, 1252.0, 1e9})
    EXPECT_EQ(rumble_of(frequency_Hz, 0), neutral) << frequency_Hz;
  EXPECT_EQ(rumble_of(160, std::numeric_limits<double>::quiet_NaN()), neutral);
  EXPECT_EQ(rumble_of(160, -1), neutral);
}

TEST(JoyConRumble, TonesAreThoseOfTheTable) {
  EXPECT_EQ(rumble_of(160, 1), (RumbleBytes{0x00, 0x01, 0x40, 0x72}));
  EXPECT_EQ(rumble_of(320, 1), (RumbleBytes{0x00, 0xC9, 0x40, 0x40}));
  EXPECT_EQ(rumble_of(231.228928, 0.501433), (RumbleBytes{0xC4, 0x88, 0x40, 0x40}));
  EXPECT_EQ(rumble_of(233, 0.501433), (RumbleBytes{0xC4, 0x88, 0x40, 0x40})) << "the nearest";
  EXPECT_EQ(rumble_of(1252.572266, 0.724662), (RumbleBytes{0xFC, 0xAB, 0x40, 0x40}));
  EXPECT_EQ(rumble_of(40.875885, 0.981378), (RumbleBytes{0x00, 0x01, 0x81, 0x71}));
  EXPECT_EQ(rumble_of(99.348625, 0.117471), (RumbleBytes{0x00, 0x01, 0x2A, 0x48}));
  EXPECT_EQ(rumble_of(160, 0.007843), (RumbleBytes{0x00, 0x01, 0xC0, 0x40}));
  EXPECT_EQ(rumble_of(216.680893, 0.066886), (RumbleBytes{0x00, 0x01, 0x4E, 0x46}));
  EXPECT_EQ(rumble_of(313.143066, 0.112491), (RumbleBytes{0xFC, 0x1E, 0x40, 0x40}));
  EXPECT_EQ(rumble_of(640, 0.094592), (RumbleBytes{0x80, 0x1D, 0x40, 0x40}));
}

TEST(JoyConRumble, EachAmplitudeOfTheTableIsItsRow) {
  for (std::size_t row = 0; row < std::size(kAmplitudes); ++row) {
    const RumbleBytes high = rumble_of(320, kAmplitudes[row]), low = rumble_of(160, kAmplitudes[row]);
    EXPECT_EQ(high[1] & 0xFE, 2 * row) << kAmplitudes[row];
    EXPECT_EQ(low[3], 0x40 + row / 2) << kAmplitudes[row];
    EXPECT_EQ(low[2], row % 2 == 1 ? 0xC0 : 0x40) << kAmplitudes[row];
  }
}

// 0xC8 and 0x72 are the largest that are known to do no harm.
TEST(JoyConRumble, NoCommandIsHarmfulAndMoreIsNeverLess) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (double frequency_Hz = 1; frequency_Hz < 5000; frequency_Hz *= 1.013) {
    int before = 0;
    for (int step = 0; step <= 3000; ++step) {
      const RumbleBytes bytes = rumble_of(frequency_Hz, 1e-3 * step);
      const int high = bytes[1] & 0xFE, low = 2 * (bytes[3] - 0x40) + (bytes[2] >> 7);
      ASSERT_LE(high, 0xC8);
      ASSERT_LE(bytes[3], 0x72);
      ASSERT_TRUE(high == 0 || low == 0) << "one band alone";
      ASSERT_GE(high / 2 + low, before) << frequency_Hz << " Hz, " << 1e-3 * step;
      before = high / 2 + low;
    }
    EXPECT_EQ(before, 100) << "the whole is the whole";
  }
  for (const double odd : {kInfinity, 1e300, 2.0, 1.7997})
    EXPECT_EQ(rumble_of(320, odd), rumble_of(320, 1)) << odd;
  for (const double odd : {-kInfinity, -5.0, 0.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(rumble_of(odd, 1), rumble_of(41, 1)) << odd;
  EXPECT_EQ(rumble_of(kInfinity, 1), rumble_of(1252.6, 1));
}

// Both bands one after the other are frequencies that only grow.
TEST(JoyConRumble, AHigherToneIsNeverToldLower) {
  double before = 0;
  for (double frequency_Hz = 30; frequency_Hz < 1400; frequency_Hz *= 1.002) {
    const RumbleBytes bytes = rumble_of(frequency_Hz, 1);
    const bool low = bytes[3] != 0x40;
    const int number = low ? (bytes[2] & 0x7F) + 0x40 : (bytes[0] + 256 * (bytes[1] & 1)) / 4 + 0x60;
    const double told_Hz = 10 * std::pow(2, number / 32.0);
    EXPECT_GE(told_Hz, before);
    if (frequency_Hz > 41 && frequency_Hz < 1252) EXPECT_NEAR(told_Hz / frequency_Hz, 1, 0.0111);
    before = told_Hz;
  }
}

// A state: three bytes of keys, and three of each stick.
Bytes state_of(std::array<std::uint8_t, 3> keys, std::array<std::uint8_t, 3> left,
               std::array<std::uint8_t, 3> right, std::uint8_t number = 0x30) {
  Bytes report(49);
  report[0] = number;
  report[1] = 0x5A;  // its clock
  report[2] = 0x8E;  // battery and connection
  std::ranges::copy(keys, report.begin() + 3);
  std::ranges::copy(left, report.begin() + 6);
  std::ranges::copy(right, report.begin() + 9);
  return report;
}

Bytes answer_to(std::uint8_t question, const Bytes& with = {}, bool done = true) {
  Bytes report = state_of({}, {0x00, 0x08, 0x80}, {0x00, 0x08, 0x80}, 0x21);
  report[13] = done ? 0x80 : 0x00;
  report[14] = question;
  std::ranges::copy(with, report.begin() + 15);
  return report;
}

constexpr std::array<std::uint8_t, 3> kStickMiddle{0x00, 0x08, 0x80};   // 0x800, 0x800
constexpr std::array<std::uint8_t, 3> kStickRightUp{0xFF, 0xFF, 0xFF};  // 0xFFF, 0xFFF
constexpr std::array<std::uint8_t, 3> kStickLeft{0x00, 0x00, 0x80};     // 0x000, 0x800

TEST(JoyCon, EachHalfBringsItsOwnAxes) {
  JoyConProtocol left(Side::left, 160), right(Side::right, 160), pro(Side::both, 160);
  const std::array<std::uint8_t, 3> zr_r_l{0xC0, 0x00, 0x40};
  const Bytes report = state_of(zr_r_l, kStickRightUp, kStickLeft);
  PushedAxes axes;
  ASSERT_TRUE(left.decode(report, axes));
  EXPECT_EQ(axes.way, Vec3(1, 1, 0));
  EXPECT_EQ(axes.turn, Vec3(0, 0, 1));
  EXPECT_EQ(axes.buttons, 0x400000U);
  ASSERT_TRUE(right.decode(report, axes));
  EXPECT_EQ(axes.way, Vec3(0, 0, -1));
  EXPECT_EQ(axes.turn, Vec3(0, -1, -1));
  EXPECT_EQ(axes.buttons, 0xC0U);
  ASSERT_TRUE(pro.decode(report, axes));
  EXPECT_EQ(axes.way, Vec3(1, 1, -1));
  EXPECT_EQ(axes.turn, Vec3(0, -1, 0));
  EXPECT_EQ(axes.buttons, 0x4000C0U);
  ASSERT_TRUE(pro.decode(state_of({0x00, 0x03, 0x80}, kStickMiddle, kStickMiddle), axes));
  EXPECT_EQ(axes.way, Vec3(0, 0, 1)) << "ZL";
  EXPECT_EQ(axes.buttons & joycon::kMinus, joycon::kMinus);
  EXPECT_EQ(axes.buttons & joycon::kPlus, joycon::kPlus);
}

TEST(JoyCon, AWornStickIsLetGo) {
  JoyConProtocol pro(Side::both, 160);
  PushedAxes axes{Vec3::Ones(), Vec3::Ones(), 1};
  // 170 of 1200 off the middle, either way.
  ASSERT_TRUE(pro.decode(state_of({}, {0xAA, 0x68, 0x75}, {0x56, 0xA7, 0x8A}), axes));
  EXPECT_TRUE(axes.rests());
}

TEST(JoyCon, WhatIsNoStateIsRefused) {
  JoyConProtocol left(Side::left, 160);
  const Bytes good = state_of({}, kStickRightUp, kStickMiddle);
  for (std::size_t length = 0; length < good.size(); ++length) {
    PushedAxes axes{Vec3::Ones(), Vec3::Ones(), 7};
    EXPECT_FALSE(left.decode(std::span(good).first(length), axes)) << length;
    EXPECT_EQ(axes.buttons, 7U);
  }
  for (const std::uint8_t number : std::initializer_list<std::uint8_t>{0x00, 0x3F, 0x31, 0x81, 0xFF}) {
    Bytes other = good;
    other[0] = number;
    PushedAxes axes;
    EXPECT_FALSE(left.decode(other, axes)) << int{number};
  }
}

// What it is asked next, without the turns that are the channels'.
Bytes next_question(JoyConProtocol& half) {
  hid::HidProtocol::Report report{};
  for (int turn = 0; turn < 2; ++turn)
    if (const std::size_t length = half.ask(report))
      return {report.begin(), report.begin() + static_cast<std::ptrdiff_t>(length)};
  return {};
}

const Bytes kSayAll{0x01, 0, 0x00, 0x01, 0x40, 0x40, 0x00, 0x01, 0x40, 0x40, 0x03, 0x30};

Bytes behind(const Bytes& question) {
  return question.size() < 10 ? Bytes{} : Bytes(question.begin() + 10, question.end());
}

TEST(JoyCon, ItIsAskedEachThingUntilItHasAnswered) {
  JoyConProtocol half(Side::left, 160);
  PushedAxes axes;
  EXPECT_EQ(next_question(half), kSayAll);
  for (int time = 1; time < 20; ++time) {
    const Bytes again = next_question(half);
    EXPECT_EQ(behind(again), (Bytes{0x03, 0x30}));
    EXPECT_EQ(again[1], time % 16) << "they are counted";
  }
  half.decode(answer_to(0x48), axes);  // to a question that is not asked
  EXPECT_EQ(behind(next_question(half)), (Bytes{0x03, 0x30}));
  half.decode(answer_to(0x03), axes);
  EXPECT_EQ(behind(next_question(half)), (Bytes{0x48, 0x01}));
  half.decode(answer_to(0x48), axes);
  EXPECT_EQ(behind(next_question(half)), (Bytes{0x30, 0x01}));
  half.decode(answer_to(0x30, {}, false), axes);  // it will not: let it be
  EXPECT_EQ(behind(next_question(half)), (Bytes{0x10, 0x3D, 0x60, 0x00, 0x00, 0x12}));
  half.decode(answer_to(0x10, {0x20, 0x60, 0x00, 0x00, 0x18}), axes);  // to somebody else's question
  EXPECT_EQ(behind(next_question(half)), (Bytes{0x10, 0x3D, 0x60, 0x00, 0x00, 0x12}));
  half.decode(answer_to(0x10, {0x3D, 0x60, 0x00, 0x00, 0x12}), axes);
  EXPECT_EQ(behind(next_question(half)), (Bytes{0x10, 0x10, 0x80, 0x00, 0x00, 0x16}));
  half.decode(answer_to(0x10, {0x10, 0x80, 0x00, 0x00, 0x16}), axes);
  EXPECT_EQ(next_question(half), Bytes{});
  // It was off and on again meanwhile, and says keys alone.
  EXPECT_FALSE(half.decode(Bytes{0x3F, 0x00, 0x00, 0x08, 0, 0x80, 0, 0x80, 0, 0x80, 0, 0x80}, axes));
  EXPECT_EQ(behind(next_question(half)), (Bytes{0x03, 0x30}));
}

TEST(JoyCon, AQuestionLeavesEveryOtherTurnToTheChannels) {
  JoyConProtocol half(Side::left, 160);
  hid::HidProtocol::Report report{};
  for (int turn = 0; turn < 10; ++turn) EXPECT_EQ(half.ask(report) > 0, turn % 2 == 0) << turn;
}

TEST(JoyCon, ChannelsAreToldTheCarrierAndAQuestionRepeatsThem) {
  JoyConProtocol pro(Side::both, 231);
  hid::HidProtocol::Report report{};
  ASSERT_EQ(pro.encode({0.501433, 1}, report), 10U);
  const Bytes told(report.begin(), report.begin() + 10);
  EXPECT_EQ(told, (Bytes{0x10, 0x00, 0xC4, 0x88, 0x40, 0x40, 0xC4, 0xC8, 0x40, 0x40}));
  const Bytes question = next_question(pro);
  EXPECT_EQ(Bytes(question.begin(), question.begin() + 10),
            (Bytes{0x01, 0x01, 0xC4, 0x88, 0x40, 0x40, 0xC4, 0xC8, 0x40, 0x40}));
  ASSERT_EQ(pro.encode({}, report), 10U);
  EXPECT_EQ(Bytes(report.begin(), report.begin() + 10),
            (Bytes{0x10, 0x02, 0x00, 0x01, 0x40, 0x40, 0x00, 0x01, 0x40, 0x40}));
}

// The sample of spi_flash_notes.md: x above 0x4F7, y 0x424; middle 0x79F, 0x8A0; below 0x510, 0x479.
const Bytes kLeftMeasured{0xF7, 0x44, 0x42, 0x9F, 0x07, 0x8A, 0x10, 0x95, 0x47};
const Bytes kRightMeasured{0x9F, 0x07, 0x8A, 0x10, 0x95, 0x47, 0xF7, 0x44, 0x42};

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// As far as it is asked for its sticks.
void wake(JoyConProtocol& half) {
  PushedAxes axes;
  for (const std::uint8_t question : std::initializer_list<std::uint8_t>{0x03, 0x48, 0x30})
    half.decode(answer_to(question), axes);
}

// 0x79F + 0x4F7, 0x8A0 + 0x424; the middle; 0x79F - 0x510, 0x8A0 - 0x479.
constexpr std::array<std::uint8_t, 3> kMeasuredEnd{0x96, 0x4C, 0xCC}, kMeasuredMiddle{0x9F, 0x07, 0x8A},
    kMeasuredBegin{0x8F, 0x72, 0x42};

TEST(JoyCon, SticksAreMeasuredByTheirMaker) {
  JoyConProtocol pro(Side::both, 160);
  wake(pro);
  PushedAxes axes;
  pro.decode(answer_to(0x10, joined({{0x3D, 0x60, 0x00, 0x00, 0x12}, kLeftMeasured, kRightMeasured})), axes);
  ASSERT_TRUE(pro.decode(state_of({}, kMeasuredEnd, kMeasuredEnd), axes));
  EXPECT_EQ(axes.way, Vec3(1, 1, 0));
  EXPECT_EQ(axes.turn, Vec3(-1, 1, 0));
  ASSERT_TRUE(pro.decode(state_of({}, kMeasuredMiddle, kMeasuredMiddle), axes));
  EXPECT_TRUE(axes.rests());
  ASSERT_TRUE(pro.decode(state_of({}, kMeasuredBegin, kMeasuredBegin), axes));
  EXPECT_EQ(axes.way, Vec3(-1, -1, 0));
  EXPECT_EQ(axes.turn, Vec3(1, -1, 0));
  // Half of the way up: 0x8A0 + 0x212.
  ASSERT_TRUE(pro.decode(state_of({}, {0x9F, 0x27, 0xAB}, kMeasuredMiddle), axes));
  EXPECT_NEAR(axes.way.y(), (0.5 - 0.15) / 0.85, 1e-3);
}

TEST(JoyCon, TheirOwnersWordCountsMore) {
  JoyConProtocol pro(Side::both, 160);
  wake(pro);
  PushedAxes axes;
  const Bytes blank(9, 0xFF),
      other{0x00, 0x04, 0x40, 0x00, 0x07, 0x70, 0x00, 0x04, 0x40};  // 0x400, 0x700, 0x400
  pro.decode(answer_to(0x10, joined({{0x3D, 0x60, 0x00, 0x00, 0x12}, other, blank})), axes);
  pro.decode(
      answer_to(
          0x10,
          joined(
              {{0x10, 0x80, 0x00, 0x00, 0x16}, {0xB2, 0xA1}, kLeftMeasured, {0xFF, 0xFF}, kRightMeasured})),
      axes);
  ASSERT_TRUE(pro.decode(state_of({}, kMeasuredEnd, kStickMiddle), axes));
  EXPECT_EQ(axes.way, Vec3(1, 1, 0));
  EXPECT_TRUE(axes.turn.isZero(0)) << "the right one was never measured: 0x800 is its middle";
}

TEST(JoyCon, FlashThatWasNeverWrittenMeasuresNothing) {
  for (const std::uint8_t filling : std::initializer_list<std::uint8_t>{0x00, 0xFF, 0x5A}) {
    JoyConProtocol pro(Side::both, 160);
    wake(pro);
    PushedAxes axes;
    pro.decode(answer_to(0x10, joined({{0x3D, 0x60, 0x00, 0x00, 0x12}, Bytes(18, filling)})), axes);
    ASSERT_TRUE(pro.decode(state_of({}, kStickMiddle, kStickRightUp), axes));
    EXPECT_TRUE(axes.way.isZero(0)) << int{filling};
    EXPECT_EQ(axes.turn, Vec3(-1, 1, 0)) << int{filling};
  }
}

// One half, as the test has it.
struct Half final : AxesSource {
  AxesReading read() noexcept override { return says; }
  void drive(const ChannelDrives& drives) noexcept override { told = drives; }
  AxesReading says;
  ChannelDrives told{};
};

TEST(JoyConPair, IsBothHalves) {
  const auto left = std::make_shared<Half>(), right = std::make_shared<Half>();
  joycon::JoyConPair pair(left, right);
  left->says = {{Vec3(0.5, -1, 1), Vec3(0, 0, 1), 0x100}, 0.002, true};
  right->says = {{Vec3(0, 0, -1), Vec3(1, 0.25, 0), 0x200}, 0.030, true};
  AxesReading both = pair.read();
  EXPECT_EQ(both.axes.way, Vec3(0.5, -1, 0));
  EXPECT_EQ(both.axes.turn, Vec3(1, 0.25, 1));
  EXPECT_EQ(both.axes.buttons, 0x300U);
  EXPECT_EQ(both.age, 0.030) << "as old as the older";
  EXPECT_TRUE(both.connected);
  for (const auto& half : {left, right}) {
    half->says.connected = false;
    EXPECT_FALSE(pair.read().connected);
    half->says.connected = true;
  }
  pair.drive({0.25, 0.75});
  EXPECT_EQ(left->told, (ChannelDrives{0.25, 0.75}));
  EXPECT_EQ(right->told, (ChannelDrives{0.25, 0.75}));
}

}  // namespace
}  // namespace fulcrum::test
