#pragma once
// The parts of a device test, each of which ends early where the bench is over.

#include "engine/app/device_test/findings.h"
#include "engine/app/device_test/person.h"
#include "engine/app/device_test/test_bench.h"

namespace fulcrum::app::device_test {

// All of them, in the order in which they stand here.
Findings walk(TestBench& bench, Person& person);

// While nothing touches the handle: how many samples come, how old they are, and how much they tremble.
void listen(TestBench& bench, Person& person, Findings& findings);

// The handle is moved along and about each axis, and each button is pressed: by a person.
void follow_hand(TestBench& bench, Person& person, Findings& findings);
void follow_buttons(TestBench& bench, Person& person, Findings& findings);

// Pushes along each axis, and turns about each where the device can, there and back. A push grows for a
// second, and ends as soon as the handle has given way.
void push(TestBench& bench, Person& person, Findings& findings);

// Short pushes, and how long they take to show in a sample (latency.h).
void measure_latency(TestBench& bench, Person& person, Findings& findings);

// Each channel by itself.
void vibrate(TestBench& bench, Person& person, Findings& findings);
// What the channels have to be made for.
VibrotactileSignal signal_of_test(const VibrotactileDesc& vibrators);

// Why the bench is over, where it is; then ticks of no force.
void end(TestBench& bench, Findings& findings);

// Of an axis, 0 to 5: the way along or about it, the other way, and what both are called.
struct Way {
  const char* there;
  const char* back;
  const char* both;
};
const Way& way_of(int axis);

// Ticks without a push until the question is answered; no: the bench is over.
Answer answer_of(TestBench& bench, Person& person, std::string_view question, Choice choice = Choice::yes_no);
// Ticks without a push.
void pause(TestBench& bench, double seconds);
// Ticks without a push until the handle rests, for two seconds at most.
void come_to_rest(TestBench& bench);
// From one pose to another: m along, rad about D's axes.
Vec6 way_between(const Pose& from, const Pose& to);

}  // namespace fulcrum::app::device_test
