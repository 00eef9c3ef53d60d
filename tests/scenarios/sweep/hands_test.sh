#!/usr/bin/env bash
# The expert sweeps three times to the right and to the left with the target's 200 mm/s: in every pass the levels follow the
# law where they are updated, to 1 %, the phantom goes against the sweep, and beyond the window and off the glass there is
# nothing. The clumsy hand is far too fast, lifts off and turns round in the window: the same holds.
. "$(dirname "$0")/../../support/hands.sh"

# HAND LEAST_PASSES: every change of the levels is an update, from where the finger was then.
levels() {
  awk -F, -v hand="$1" -v least="$2" '
    function law(x) { return 12.838 * log(1 + x / 0.001) / log(1 + 0.01 / 0.001) }
    function off(level, wanted) { return (level - wanted) ^ 2 > 0.12838 ^ 2 }
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    {
      x = $at["vibrotactile_motion/x"]; l = $at["vibrotactile_motion/level/left"]; r = $at["vibrotactile_motion/level/right"]; d = $at["vibrotactile_motion/direction"]
      if ((l > 0 || r > 0) && $at["contact/regions"] == 0) wrong = "it vibrates off the glass"
      if (l < 0 || r < 0 || l > 12.839 || r > 12.839) wrong = "a level is out of range"
      # In the first half second all that the device does comes in slowly.
      if ($at["timestamp"] > 0.5 && (l != last_l || r != last_r) && (l > 0 || r > 0)) {
        ++updates
        gone = d * x  # into the window
        if (gone < 0 || gone > 0.010001) wrong = "an update beyond the window"
        else if (off(d > 0 ? l : r, law(gone)) || off(d > 0 ? r : l, law(0.01 - gone))) { bad = $at["timestamp"]; wrong = "a level is not that of the law" }
        if (last_l == 0 && last_r == 0) ++passes
      }
      last_l = l; last_r = r
    }
    END {
      print hand ": " updates " updates in " passes " passes"
      if (passes < least || updates < 3 * least) wrong = "those are not the passes"
      if (hand == "expert" && passes != 6) wrong = "the expert does not pass six times"
      if (wrong) { print "FAILED: " wrong " " bad; exit 1 }
    }' "$box/$1/trace.csv"
}

deepest=3e-4 # m: the pad is pressed on by far more than its weight
run_hand sweep expert 0 3
levels expert 6
run_hand sweep clumsy 3 8
levels clumsy 8

# What the right channel is given of the six passes is six bursts, whose envelope, rising and falling by 1 % of its strength
# a sample at most, has no jump: of a tone s whose envelope bends by b, s[n+1] - 2 cos(w) s[n] + s[n-1] is b at most where s
# is largest, and little more than nothing where it does not bend.
bursts() {
  od -An -v -t d2 -w2 -j44 "$1" | awk '
    BEGIN { strength = 32767 * 12.838 / 12.84; twice = 2 * cos(2 * 3.14159265358979 * 233 / 48000) }
    { bend = $1 - twice * last + before; before = last; last = $1; if (bend < 0) bend = -bend; if (bend > most) most = bend }
    $1 > loudest { loudest = $1 }
    $1 == 0 { ++still; next }
    { if (!count || still > 240) ++count; still = 0 }
    END {
      print count " bursts, the loudest of " loudest / strength " of the strength, bends of " most / strength
      if (count != 6) wrong = "there are not six bursts"
      if (loudest < 0.9 * strength || loudest > 1.001 * strength) wrong = "they are not as loud as they should be"
      if (most > 0.012 * strength + 3) wrong = "the envelope jumps"
      if (wrong) { print "FAILED: " wrong; exit 1 }
    }'
}
bursts "$box/expert/vibrotactile_motion-right.wav"
all_hands_ran
