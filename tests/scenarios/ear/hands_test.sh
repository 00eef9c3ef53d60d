#!/usr/bin/env bash
# The expert completes the task without a hard touch; the clumsy hand does not, touches hard, and neither gets more than
# 0.1 mm into what it touches. What the summary says of hard touches is what the trace ends with, and a replay says the
# same.
. "$(dirname "$0")/../../support/hands.sh"
run() { # HAND CODE
  run_hand ear "$1" "$2" 7.9
  awk -F, -v hard="$(figure "$box/$1/summary.json" hard_touches)" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "task/hard_touches") at = i; next }
    $at < before { print "FAILED: the count falls"; exit 1 }
    { before = $at }
    END { if (!at || before != hard) { print "FAILED: the trace ends with " before " hard touches"; exit 1 } }
  ' "$box/$1/trace.csv"
}
run expert 0
[ "$(figure "$box/expert/summary.json" hard_touches)" = 0 ] || fail "the expert touches hard"
run clumsy 3
[ "$(figure "$box/clumsy/summary.json" hard_touches)" -ge 3 ] || fail "the clumsy hand hardly touches"
grep -q '"reached_s": [0-9]' "$box/clumsy/summary.json" && fail "the clumsy hand reaches a checkpoint"
"$FULCRUM" replay "$box/clumsy/tape" --out "$box/replay" >"$box/log" 2>&1 || { cat "$box/log"; fail "it replays otherwise"; }
[ "$(figure "$box/replay/summary.json" hard_touches)" = "$(figure "$box/clumsy/summary.json" hard_touches)" ] ||
  fail "a replay counts otherwise"
all_hands_ran
