#!/usr/bin/env bash
# The expert touches the ball at three places of the stick and moves the hand along it while it presses; the clumsy hand
# holds so loosely that the strip loses it while it presses, and the point fades to the scene's own. Neither makes the
# commanded wrench step, nor the loop give out energy.
. "$(dirname "$0")/../../support/hands.sh"

# HAND: what must hold in every tick, and what the holding point did while the ball was touched.
watch() {
  awk -F, -v hand="$1" '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    {
      t = $at["timestamp"]; touches = $at["contact/regions"] > 0; place = $at["holding_point/place"]; state = $at["holding_point/state"]
      for (i = 1; i <= 3; ++i) {
        axis = substr("xyz", i, 1); f = $at["device/force/" axis]; m = $at["device/torque/" axis]
        step_f += (f - last_f[i]) ^ 2; step_m += (m - last_m[i]) ^ 2; last_f[i] = f; last_m[i] = m
      }
      if (NR > 2 && sqrt(step_f) > most_f) most_f = sqrt(step_f)
      if (NR > 2 && sqrt(step_m) > most_m) most_m = sqrt(step_m)
      step_f = step_m = 0
      if (hand == "expert" && int($at["fault"] / 2 ^ 27) % 2) wrong = "the compensation faded"
      if (NR > 2 && (place - before) ^ 2 > 0.000201 ^ 2) wrong = "the holding point steps"
      before = place
      lost = int($at["fault"] / 2 ^ 26) % 2
      if (touches && lost != (state >= 2)) wrong = "the fault does not say what the state does"
      if (touches) { states[state] = 1; if (!n++ || place < low) low = place; if (place > high) high = place }
      if (touches && state == 4) ends = place
      if ($at["contact/regions"] > 0 && $at["holding_point/limit"] <= 0) wrong = "no limit where it touches"
    }
    END {
      printf "%s: steps of %.4f N and %.5f N m at most; held from %.0f to %.0f mm while it touched\n", hand, most_f, most_m, low * 1e3, high * 1e3
      if (most_f > 0.501 || most_m > 0.0901) wrong = "the wrench steps"
      if (hand == "expert" && most_f > 0.2) wrong = "the force is not smooth"
      if (hand == "expert" && (low > 0.065 || high < 0.135)) wrong = "the hand did not move along the stick"
      if (hand == "expert" && (states[2] || states[3] || states[4])) wrong = "the strip lost the hand"
      if (hand == "clumsy" && !(states[1] && states[2] && states[3] && states[4])) wrong = "the strip did not lose the hand, or nothing faded"
      if (hand == "clumsy" && (ends - 0.1) ^ 2 > 1e-8) wrong = "it did not end where the scene says"
      if (wrong) { print "FAILED: " wrong; exit 1 }
    }' "$box/$1/trace.csv"
}

deepest=0.03 # m: the ball is soft, and the tool is where the hand wants it
run_hand stick expert 0 2.6
watch expert
run_hand stick clumsy 3 2.6
watch clumsy
grep -q "holding_point_lost" "$box/clumsy/summary.json" || fail "the summary does not say that the holding point was lost"
all_hands_ran
