#!/usr/bin/env bash
# The expert completes the task, the clumsy hand does not, and neither gets more than 0.1 mm into what it touches.
. "$(dirname "$0")/../../support/hands.sh"
run_hand teeth expert 0 7.9
run_hand teeth clumsy 3 7.9
echo "all good"
