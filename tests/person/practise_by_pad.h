#pragma once
// A task, done by a gamepad: the sticks are held as far as the ring is away, and let go in it.

#include "tests/person/pad.h"
#include "tests/person/trainee.h"

namespace fulcrum::person {

// In the view that is shown; nothing may be in the way. Throws GaveUp.
void practise_by_pad(Trainee& trainee, Pad& pad, std::size_t checkpoints);

}  // namespace fulcrum::person
