#!/usr/bin/env bash
# The expert completes the task: twelve knocks against one peg each, then the row, whose five pegs are met within 20 ms,
# all gently. The clumsy hand does not complete it, and bangs.
. "$(dirname "$0")/../support/hands.sh"
run_hand knock expert 0 8
touches expert | awk '
  { print; if ($2 < 0.1 || $2 > 0.4 || $4 != (NR == 13 ? 5 : 1)) { print "FAILED: that is no such knock"; bad = 1 } }
  END { if (NR != 13) { print "FAILED: " NR " knocks"; bad = 1 } exit bad }'
run_hand knock clumsy 3 8
touches clumsy | awk '
  { if ($2 > fastest) fastest = $2 }
  END { print NR " touches, the fastest with " fastest " m/s"; if (NR < 10 || fastest < 0.5) { print "FAILED: not clumsy"; exit 1 } }'
echo "all good"
