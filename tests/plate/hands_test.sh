#!/usr/bin/env bash
# The expert completes the task with six taps, each with about 0.15 m/s and in one place; the clumsy hand does not
# complete it, and strikes hard and often.
. "$(dirname "$0")/../support/hands.sh"
run_hand plate expert 0 6.6
touches expert | awk '
  { print; if ($2 < 0.1 || $2 > 0.2 || $4 != 1) { print "FAILED: that is no tap"; bad = 1 } }
  END { if (NR != 6) { print "FAILED: " NR " taps"; bad = 1 } exit bad }'
run_hand plate clumsy 3 6.6
touches clumsy | awk '
  { if ($2 > fastest) fastest = $2 }
  END { print NR " touches, the fastest with " fastest " m/s"; if (NR < 10 || fastest < 0.5) { print "FAILED: not clumsy"; exit 1 } }'
echo "all good"
