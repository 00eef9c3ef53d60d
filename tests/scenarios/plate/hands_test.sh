#!/usr/bin/env bash
# The expert completes the task with six taps, each with about 0.15 m/s and in one place, and each is braked: in the tick
# of contact and in no other, by what the motors have, against the hand's way. The clumsy hand does not complete it, and
# strikes hard and often; its pulses keep to the same limits.
. "$(dirname "$0")/../../support/hands.sh"

# HAND: its pulses. Every motor within its limit in every tick; the port as passive as it must be.
pulses() {
  awk -F, -v hand="$1" '
    NR == 1 { for (i = 1; i <= NF; ++i) { at[$i] = i; if ($i ~ /^actuator\/load\//) motor[++motors] = i } next }
    {
      for (m = 1; m <= motors; ++m) if ($motor[m] > 1 || $motor[m] < -1) wrong = "a motor is beyond its limit"
      along = 0; size = 0
      for (i = 1; i <= 3; ++i) {
        axis = substr("xyz", i, 1)
        along += $at["braking_pulse/force/" axis] * $at["impact/normal/" axis]
        size += $at["braking_pulse/force/" axis] ^ 2
      }
      if (size > 0) {
        ++pulses
        if (before > 0 || $at["contact/regions"] == 0) wrong = "a pulse is not in the tick of contact"
        if (along < 0.999999 * sqrt(size)) wrong = "a pulse does not go along the normal"  # the base is not turned
      }
      before = $at["contact/regions"]; energy = $at["braking_pulse/energy"]; moment = $at["braking_pulse/moment_energy"]
    }
    END {
      print hand ": " pulses " pulses of " motors " motors took " (0 - energy) " J; their moment gave " moment " J"
      if (wrong) { print "FAILED: " wrong; exit 1 }
      if (motors != 7 || energy >= 0 || pulses < 6) { print "FAILED: that brakes no hand"; exit 1 }
    }' "$box/$1/trace.csv"
}

run_hand plate expert 0 6.6
touches expert | awk '
  { print; if ($2 < 0.1 || $2 > 0.2 || $4 != 1) { print "FAILED: that is no tap"; bad = 1 } }
  END { if (NR != 6) { print "FAILED: " NR " taps"; bad = 1 } exit bad }'
pulses expert
run_hand plate clumsy 3 6.6
touches clumsy | awk '
  { if ($2 > fastest) fastest = $2 }
  END { print NR " touches, the fastest with " fastest " m/s"; if (NR < 10 || fastest < 0.5) { print "FAILED: not clumsy"; exit 1 } }'
pulses clumsy
all_hands_ran
