#!/usr/bin/env bash
# The expert completes the task: twelve knocks against one peg each, then the row, whose five pegs are met within 20 ms,
# all gently. The clumsy hand does not complete it, and bangs.
. "$(dirname "$0")/../../support/hands.sh"
run_hand knock expert 0 8
touches expert | awk '
  { print; if ($2 < 0.1 || $2 > 0.4 || $4 != (NR == 13 ? 5 : 1)) { print "FAILED: that is no such knock"; bad = 1 } }
  END { if (NR != 13) { print "FAILED: " NR " knocks"; bad = 1 } exit bad }'
# Each blow is felt from the next tick on, about an axis at right angles to lever and normal; five voices of the row sound
# together, and none is dropped.
awk -F, '
  function size(name) { return sqrt($at[name "/x"] ^ 2 + $at[name "/y"] ^ 2 + $at[name "/z"] ^ 2) }
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  struck && size("impact_vibration/torque") == 0 { wrong = "a blow is not felt in the next tick" }
  { struck = $at["impact/count"]; blows += struck; if ($at["impact_vibration/voices"] > most) most = $at["impact_vibration/voices"] }
  struck {
    across = 0
    for (i = 1; i <= 3; ++i) across += $at["impact_vibration/axis/" substr("xyz", i, 1)] * $at["impact/normal/" substr("xyz", i, 1)]
    if (across > 0.0175 || across < -0.0175) wrong = "an axis is not at right angles to the blow"
    if ($at["impact_vibration/frequency_Hz"] < 12 || $at["impact_vibration/frequency_Hz"] > 40) wrong = "a frequency is out of range"
  }
  { dropped = $at["impact_vibration/dropped"]; energy = $at["impact_vibration/energy"] }
  END {
    print blows " blows, at most " most " voices, " dropped " dropped, " energy " J to the hand"
    if (blows != 17 || most != 5 || dropped != 0) wrong = "those are not the expert'"'"'s blows"
    if (wrong) { print "FAILED: " wrong; exit 1 }
  }' "$box/expert/trace.csv"
run_hand knock clumsy 3 8
touches clumsy | awk '
  { if ($2 > fastest) fastest = $2 }
  END { print NR " touches, the fastest with " fastest " m/s"; if (NR < 10 || fastest < 0.5) { print "FAILED: not clumsy"; exit 1 } }'
all_hands_ran
