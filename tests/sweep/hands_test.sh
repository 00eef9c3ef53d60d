#!/usr/bin/env bash
# The expert sweeps three times to the right and to the left with the target's 200 mm/s: in every pass the levels follow the
# law where they are updated, to 1 %, the phantom goes against the sweep, and beyond the window and off the glass there is
# nothing. The clumsy hand is far too fast, lifts off and turns round in the window: the same holds.
. "$(dirname "$0")/../support/hands.sh"

# HAND LEAST_PASSES: every change of the levels is an update, from where the finger was then.
levels() {
  awk -F, -v hand="$1" -v least="$2" '
    function law(x) { return 12.838 * log(1 + x / 0.001) / log(1 + 0.01 / 0.001) }
    function off(level, wanted) { return (level - wanted) ^ 2 > 0.12838 ^ 2 }
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    {
      x = $at["touch/x"]; l = $at["touch/left"]; r = $at["touch/right"]; d = $at["touch/direction"]
      if ($at["energy/port"] < -1e-4) wrong = "the port gives out energy"
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
ls "$box"/expert/*.wav >/dev/null 2>&1 || fail "there is no WAV of the channels"
echo "all good"
