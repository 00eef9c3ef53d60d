#!/usr/bin/env bash
# The expert completes the task, the clumsy hand does not, and neither gets more than 0.1 mm into what it touches.
. "$(dirname "$0")/../../support/hands.sh"
run_hand teeth expert 0 7.9
# It trembles on the border of a count, where the observer reads far below the truth: port_energy_test.cpp holds it to the
# truth itself.
least_port=-0.1
run_hand teeth clumsy 3 7.9
all_hands_ran
