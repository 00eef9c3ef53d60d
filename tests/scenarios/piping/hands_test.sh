#!/usr/bin/env bash
# The expert completes the task, and so does a hand that yields where it is told; the clumsy one and one that holds still do
# not. None gets more than 0.1 mm into what it touches.
. "$(dirname "$0")/../../support/hands.sh"
run_hand piping expert 0 7.9
run_hand piping clumsy 3 7.9
run_hand piping still 3 7.9
run_hand piping yielding 0 7.9
all_hands_ran
