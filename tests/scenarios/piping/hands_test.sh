#!/usr/bin/env bash
# The expert completes the task, and so does a hand that yields where it is told; the clumsy one and one that holds still do
# not. None gets farther into what it touches than the distance field errs, as `fulcrum explain piping` says: 0.17 mm on 95 %
# of the surface, more in some places.
. "$(dirname "$0")/../../support/hands.sh"
deepest=2e-4 # m
run_hand piping expert 0 7.9
run_hand piping clumsy 3 7.9
run_hand piping still 3 7.9
run_hand piping yielding 0 7.9
all_hands_ran
