#pragma once
// From ring to ring, until the list is full.

#include "tests/person/plans.h"
#include "tests/person/trainee.h"

namespace fulcrum::person {

// Throws GaveUp.
void practise(Trainee& trainee, const Plan& plan);

}  // namespace fulcrum::person
