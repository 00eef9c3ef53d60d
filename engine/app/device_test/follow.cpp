#include <cmath>
#include <string>

#include "engine/app/device_test/parts.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kFarWay = 0.02;  // m, and
constexpr double kFarTurn = 0.3;  // rad: so far is meant, and not by chance

constexpr const char* kAsked[] = {"Move it to the right.",
                                  "Move it up.",
                                  "Move it toward you.",
                                  "Tilt its top toward you.",
                                  "Turn it anticlockwise as seen from above.",
                                  "Turn it anticlockwise as you see it from where you sit."};

struct Motion {
  bool asked = true;  // false: the person left it out
  int axis = -1;      // along or about which it went far first; -1: it did not
  bool back = false;  // the other way round
  Vec6 way = Vec6::Zero();
};

Motion motion_of(TestBench& bench, Person& person, int asked) {
  come_to_rest(bench);
  const Pose begun = bench.tick().sample.X_DH;
  person.ask(std::string(kAsked[asked]) + " Is it there? n leaves this out.", Choice::yes_no);
  Motion motion;
  Vec6 far;
  far << Vec3::Constant(kFarWay), Vec3::Constant(kFarTurn);
  while (!bench.over()) {
    motion.way = way_between(begun, bench.tick().sample.X_DH);
    const Vec6 parts = motion.way.cwiseQuotient(far);
    Eigen::Index axis = 0;
    const std::optional<Answer> answer = person.answer();
    if (parts.cwiseAbs().maxCoeff(&axis) >= 1) {
      motion.axis = static_cast<int>(axis);
      motion.back = parts[axis] < 0;
      person.tell("");
      return motion;
    }
    motion.asked = answer != Answer::no;
    if (answer) return motion;
  }
  motion.asked = false;
  return motion;
}

Part part_of(int asked, const Motion& motion) {
  const std::string wanted = way_of(asked).there;
  Part part{.name = std::string("hand, ") + way_of(asked).both};
  if (!motion.asked) {
    part.says = "Left out.";
    return part;
  }
  part.outcome = Outcome::bad;
  part.measures = {{"way", 1e3 * motion.way.head<3>().norm(), "mm"},
                   {"turn", motion.way.tail<3>().norm(), "rad"}};
  if (motion.axis < 0) {
    part.says = "It is connected, but its pose does not move: switch it off and on, and calibrate it.";
    return part;
  }
  const Way& way = way_of(motion.axis);
  const std::string went = motion.back ? way.back : way.there;
  if (motion.axis != asked) {
    part.says = "Asked to go " + wanted + ", it went " + went +
                ": its axes are swapped, or it stands turned. Turn it so that its front is toward you.";
  } else if (motion.back) {
    part.says = "Asked to go " + wanted + ", it went " + went +
                ": this axis is the wrong way round. Turn it so that its front is toward you.";
  } else {
    part.outcome = Outcome::good;
    part.says = "It went " + went + ", as asked.";
  }
  return part;
}

std::string bits_in_words(std::uint32_t bits) {
  std::string words;
  for (int bit = 0; bit < 32; ++bit)
    if ((bits >> bit & 1U) != 0) words.append(words.empty() ? "" : ", ").append(std::to_string(bit));
  return words;
}

}  // namespace

void follow_hand(TestBench& bench, Person& person, Findings& findings) {
  if (!person.there()) {
    findings.parts.push_back({"hand", Outcome::unknown, "Nobody was there to move it."});
    return;
  }
  const int axes = bench.desc().senses_rotation ? 6 : 3;
  for (int axis = 0; axis < axes && !bench.over(); ++axis) {
    const Motion motion = motion_of(bench, person, axis);
    findings.parts.push_back(part_of(axis, motion));
    person.tell(findings.parts.back().says);
  }
}

void follow_buttons(TestBench& bench, Person& person, Findings& findings) {
  if (!person.there()) {
    findings.parts.push_back({"buttons", Outcome::unknown, "Nobody was there to press them."});
    return;
  }
  std::uint32_t pressed = 0;
  person.ask("Press each of its buttons once. Done? n if it has none.", Choice::yes_no);
  std::optional<Answer> answer;
  while (!bench.over() && !answer) {
    pressed |= bench.tick().sample.buttons;
    answer = person.answer();
  }
  if (!answer) return;
  Part part{.name = "buttons"};
  if (pressed != 0) {
    part.outcome = Outcome::good;
    part.says = "Pressed, by number: " + bits_in_words(pressed) + ".";
  } else if (*answer == Answer::yes) {
    part.outcome = Outcome::bad;
    part.says = "None of them arrived: it is connected, and its buttons say nothing.";
  } else {
    part.says = "It has none, or they were left out.";
  }
  part.measures = {{"buttons pressed", static_cast<double>(pressed), "bits"}};
  findings.parts.push_back(std::move(part));
}

}  // namespace fulcrum::app::device_test
