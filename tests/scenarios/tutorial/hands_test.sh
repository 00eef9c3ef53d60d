#!/usr/bin/env bash
# The expert completes the five lessons without a hard touch, in time for a person to take many times as long; the stop is in
# the tape, so that a replay judges the same. The clumsy hand does not complete them, and bangs. Whoever does all that the
# expert does but stop does not complete them either.
. "$(dirname "$0")/../../support/hands.sh"
run_hand tutorial expert 0 3
took=$(figure "$box/expert/summary.json" completion_time_s)
awk -v took="$took" 'BEGIN { print "expert: " took " s"; exit !(took > 10 && took < 30) }' || fail "that is no lesson of two minutes"
[ "$(figure "$box/expert/summary.json" hard_touches)" = 0 ] || fail "the expert touches hard"
"$FULCRUM" replay "$box/expert/tape" --out "$box/again" >"$box/log" 2>&1 || { cat "$box/log"; fail "the replay differs"; }
cmp "$box/expert/trace.csv" "$box/again/trace.csv" || fail "the replay's trace differs"
[ "$(figure "$box/again/summary.json" completion_time_s)" = "$took" ] || fail "the replay is judged otherwise"

# The force is stopped once, at the last checkpoint, for as long as the path says.
awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  { stopped = $at["fault"] % 2 }
  stopped { ++ticks; if ($at["task/step"] != 5) wrong = "it stops elsewhere" }
  stopped && !before { ++stops }
  { before = stopped }
  END {
    print stops + 0 " stop of " ticks + 0 " ticks"
    if (wrong || stops != 1 || ticks < 790 || ticks > 810) { print "FAILED: " wrong; exit 1 }
  }' "$box/expert/trace.csv"

deepest=1.5e-4 # m: the blade is flung against a wire of 2.6 mm and the corners of a box
run_hand tutorial clumsy 3 6.6
hard=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "task/hard_touches") at = i } END { print $at }' "$box/clumsy/trace.csv")
echo "clumsy: $hard hard touches"
[ "$hard" -ge 2 ] || fail "the clumsy hand is gentle"

cp -rL "$FULCRUM_CONTENT/scenarios/tutorial" "$box/stopless"
sed -i '/^ *stop:/d' "$box/stopless/expert.yaml"
code=0
"$FULCRUM" run "$box/stopless/scenario.yaml" --headless --hand expert --seconds 40 --size 64x36 --out "$box/went_on" >"$box/log" 2>&1 || code=$?
[ "$code" = 3 ] || { cat "$box/log"; fail "without a stop it ended with $code"; }
[ "$(grep -c '"reached_s": [0-9]' "$box/went_on/summary.json")" = 5 ] || fail "without a stop other lessons are missing, too"
all_hands_ran
