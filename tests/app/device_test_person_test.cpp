// What a device test asks of a person, and what follows from the answers.

#include <pty.h>
#include <unistd.h>

#include "haptics/math/rotation.h"
#include "tests/app/tested_devices.h"

namespace fulcrum::test {
namespace {

TEST(DeviceTestPerson, NothingPushesWhereThePersonDeclines) {
  Free device(arm());
  dt::TestBench bench = bench_of(device);
  Scripted person;
  person.says = [](const std::string& question) {
    return question.find("going to") != std::string::npos ? Answer::no : Answer::yes;
  };
  const dt::Findings findings = dt::walk(bench, person);
  for (const Wrench& F : device.told) EXPECT_TRUE(F.is_zero());
  for (const char* const name : kPushes) EXPECT_EQ(part(findings, name).outcome, Outcome::unknown);
  EXPECT_EQ(part(findings, "latency").outcome, Outcome::unknown);
  EXPECT_EQ(
      std::ranges::count_if(
          person.asked, [](const std::string& q) { return q.find("going to push") != std::string::npos; }),
      4);  // along three axes, and for the latency
}

TEST(DeviceTestPerson, WhatAPersonDoesNotFeelIsBad) {
  Free device(arm());
  dt::TestBench bench = bench_of(device);
  Scripted person;
  person.says = [](const std::string& question) {
    return question.find("Did it go up") != std::string::npos ? Answer::no : Answer::yes;
  };
  const dt::Findings findings = dt::walk(bench, person);
  EXPECT_EQ(part(findings, kPushes[0]).outcome, Outcome::good);
  EXPECT_EQ(part(findings, kPushes[1]).outcome, Outcome::bad);
}

// The hand does as it is asked, but for x and y of the device, which are swapped, and z, which is turned
// round.
TEST(DeviceTestPerson, AxesThatAreSwappedOrTurnedRoundAreNamed) {
  Played device(arm());
  Scripted person;
  person.on_ask = [&](const std::string& question) {
    if (question.find("to the right") != std::string::npos) device.place.y() += 0.03;
    if (question.find("Move it up") != std::string::npos) device.place.y() += 0.03;
    if (question.find("Move it toward") != std::string::npos) device.place.z() -= 0.03;
    if (question.find("Tilt") != std::string::npos)
      device.sample.X_DH.q = quaternion_exp(Vec3(0.4, 0, 0)) * device.sample.X_DH.q;
    device.sample.buttons = question.find("buttons") != std::string::npos ? 5 : 0;
  };
  dt::TestBench bench = bench_of(device);
  const dt::Findings findings = dt::walk(bench, person);
  EXPECT_NE(part(findings, "hand, right and left").says.find("it went up: its axes are swapped"),
            std::string::npos);
  EXPECT_EQ(part(findings, "hand, right and left").outcome, Outcome::bad);
  EXPECT_EQ(part(findings, "hand, up and down").outcome, Outcome::good);
  EXPECT_NE(
      part(findings, "hand, near and far").says.find("it went away from you: this axis is the wrong way"),
      std::string::npos);
  EXPECT_EQ(part(findings, "hand, tilting").outcome, Outcome::good);
  EXPECT_NE(part(findings, "hand, turning").says.find("its pose does not move"), std::string::npos);
  EXPECT_EQ(part(findings, "buttons").outcome, Outcome::good);
  EXPECT_NE(part(findings, "buttons").says.find("0, 2"), std::string::npos);
}

// Stdin is a terminal while this lives; who writes to `hand` types.
class Terminal {
public:
  Terminal() : stdin_(dup(STDIN_FILENO)) {
    int end = -1;
    good = openpty(&hand, &end, nullptr, nullptr, nullptr) == 0;
    dup2(end, STDIN_FILENO);
    close(end);
  }
  ~Terminal() {
    dup2(stdin_, STDIN_FILENO);
    close(stdin_);
    if (hand >= 0) close(hand);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  void type(const std::string& text) const {
    EXPECT_EQ(write(hand, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  bool good = false;
  int hand = -1;

private:
  int stdin_;
};

Answer awaited(dt::Person& person) {
  for (;;)
    if (const std::optional<Answer> answer = person.answer()) return *answer;
}

TEST(DeviceTestPerson, APersonAtTheTerminalAnswersTheNewestQuestion) {
  Terminal terminal;
  ASSERT_TRUE(terminal.good);
  dt::PersonAtTerminal person;
  terminal.type("\n\n");
  person.ask("Push?", dt::Choice::yes_no);
  EXPECT_FALSE(person.answer()) << "what was typed before the question is no answer";
  terminal.type("n\n");
  EXPECT_EQ(awaited(person), Answer::no);
  person.ask("Push?", dt::Choice::yes_no);
  terminal.type("what\n");
  terminal.type("\n");
  EXPECT_EQ(awaited(person), Answer::yes);
  for (const auto& [typed, means] : {std::pair("l\n", Answer::left), std::pair("R\n", Answer::right),
                                     std::pair("\n", Answer::no), std::pair("y\nleft\n", Answer::left)}) {
    person.ask("Which hand?", dt::Choice::hand);
    terminal.type(typed);
    EXPECT_EQ(awaited(person), means) << typed;
  }
  person.ask("Push?", dt::Choice::yes_no);
  terminal.type("l\ny\n");
  EXPECT_EQ(awaited(person), Answer::yes) << "l is no answer to that";
  person.ask("Push?", dt::Choice::yes_no);
  close(std::exchange(terminal.hand, -1));
  EXPECT_EQ(awaited(person), Answer::no) << "a terminal that is gone agrees to nothing";
}

}  // namespace
}  // namespace fulcrum::test
