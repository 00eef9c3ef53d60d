#!/usr/bin/env bash
# The expert starts the nut and runs it down to its washer: each turn takes it along by a pitch. A hand that tilts it on
# the thread is told so, and yields, and completes the task; the clumsy one does not. None of them gets into bolt or pipe by
# 10 um, and none is held where nothing holds it.
. "$(dirname "$0")/../../support/hands.sh"

# HAND: how often its motion was limited, and what a turn of the nut on the thread took it along.
watch() {
  awk -F, -v hand="$1" '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    {
      ++n; if (int($at["fault"] / 2 ^ 20) % 2) ++limited
      z = $at["tool/p/z"]; angle = 2 * atan2($at["tool/q/z"], $at["tool/q/w"]); vibration = $at["torque_substitution/vibration"]
      if (vibration > told) told = vibration
      if (NR > 2) { d = angle - before; while (d > 3.14159265) d -= 6.28318531; while (d < -3.14159265) d += 6.28318531; turned += d }
      before = angle
      if (!from && z < 0.0138 && $at["task/step"] >= 3) { from = z; turned_from = turned }
      if (from && z > 0.0060) { to = z; turned_to = turned }
    }
    END {
      printf "%s: limited in %d of %d ticks, told of torque with up to %.2f N\n", hand, limited, n, told
      if (limited > n / 100) wrong = "its motion was limited"
      if (hand == "yielding" && told < 0.05) wrong = "it was not told that it tilts the nut"
      if (hand != "clumsy") {
        pitch = turned_to == turned_from ? 0 : (to - from) / (turned_to - turned_from) * 6.28318531 * 1e3
        printf "%s: %.4f mm a turn, over %.1f turns\n", hand, pitch, (turned_from - turned_to) / 6.28318531
        if (pitch < 1.74 || pitch > 1.76 || turned_from - turned_to < 24) wrong = "the thread does not take the nut along"
      }
      if (wrong) { print "FAILED: " wrong; exit 1 }
    }' "$box/$1/trace.csv"
}

deepest=1e-5 # m
run_hand nut expert 0 2
watch expert
run_hand nut clumsy 3 7.9
watch clumsy
run_hand nut yielding 0 7.9
watch yielding
diff <("$MAKE" --tilted) "$SCENARIO/yielding.yaml" || fail "yielding.yaml is not what make_nut --tilted writes"
all_hands_ran
