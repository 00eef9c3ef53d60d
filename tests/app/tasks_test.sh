#!/usr/bin/env bash
# The lessons of docs/tasks.md, as they stand there: carried out by a hand, judged alike in a replay, and told where the
# hand is careless. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
here=$(dirname "$(readlink -f "$0")")
page=$here/../../docs/tasks.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

expect 0 'is made' "$FULCRUM" new lesson
# lesson_of N NAME: the page's Nth lesson, in the place of the task that a new scenario has.
lesson_of() {
  [ "$2" = lesson ] || cp -r lesson "$2"
  sed -n '/^```yaml/,/^```/p' "$page" | awk -v n="$1" '/^```yaml/ { ++block; next } /^```/ { next } block == n' >"$2/task"
  { sed '/^dwell/,$d' lesson.yaml; cat "$2/task"; sed -n '/^hands/,$p' lesson.yaml; } >"$2/scenario.yaml"
  cp "$here/tasks/$2.yaml" "$2/expert.yaml"
}
cp lesson/scenario.yaml lesson.yaml
lesson_of 1 lesson
lesson_of 2 free
grep -q 'follow:' lesson/scenario.yaml && grep -q 'order: any' free/scenario.yaml || fail "the page has other lessons"

# field FOLDER NAME: a line of its summary.
field() { grep -E "\"$2\"" "$1/summary.json" | tr -d ' ,'; }
# has FOLDER NAME VALUE
has() { [ "$(field "$1" "$2")" = "\"$2\":$3" ] || fail "$1 has $(field "$1" "$2"), not $3"; }

# --- every kind of checkpoint, by a hand that knows how
expect 0 '^lesson/scenario.yaml: good$' "$FULCRUM" check lesson/scenario.yaml
expect 0 'Completed' "$FULCRUM" run lesson/scenario.yaml --headless --hand expert --out L
grep -q 'null' <(sed -n '/"checkpoints"/,/\]/p' L/summary.json) && fail "a checkpoint was not reached"
has L slips 0
has L trespasses 0
has L hard_touches 0
expect 0 'bit for bit' "$FULCRUM" replay L/tape --out LR
diff <(sed -n '/"checkpoints"/,/\]/p' L/summary.json) <(sed -n '/"checkpoints"/,/\]/p' LR/summary.json) || fail "a replay judges otherwise"

# --- a careless one: over the line's side, through what is to be avoided, too hard, the tool askew, the optional one left out
cp -r lesson careless
awk '/\[0.03, -0.001, 0.032/ { print "  - {position: [-0.01, -0.001, 0.032], orientation: [1, 0, 0, 0], travel: 1}"
                             print "  - {position: [0, 0.01, 0.032], orientation: [1, 0, 0, 0], travel: 1}"
                             print "  - {position: [-0.02, -0.001, 0.032], orientation: [1, 0, 0, 0], travel: 1}" }
     /0, 0.03, -0.045/ { next }
     /0.05, 0.03, 0\], .*dwell: 1.6/ { sub(/1, 0, 0, 0/, "0.98, 0.2, 0, 0") }
     /0, 0.0135, 0\], .*travel: 1,/ { sub(/0.0135/, "0.000"); print "  - {position: [-0.025, 0.017, 0], orientation: [1, 0, 0, 0], travel: 1}" }
     { print }' lesson/expert.yaml >careless/expert.yaml
expect 3 'Not completed' "$FULCRUM" run careless/scenario.yaml --headless --hand expert --out C
has C slips 1
has C trespasses 1
for name in 'hold it upright' 'a glance behind'; do
  grep -A1 "\"$name\"" C/summary.json | grep -q null || fail "'$name' was reached"
done
expect 0 'bit for bit' "$FULCRUM" replay C/tape --out CR
for name in slips trespasses trespass_s hard_touches completed; do
  [ "$(field C $name)" = "$(field CR $name)" ] || fail "a replay counts other $name"
done

# --- any order, and another task for every seed
expect 0 '^free/scenario.yaml: good$' "$FULCRUM" check free/scenario.yaml
for seed in 1 2 3 4 5 6 7 8; do
  expect 0 'Completed' "$FULCRUM" run free/scenario.yaml --headless --hand expert --set seed=$seed --out F$seed
  [ "$(grep -c reached_s F$seed/summary.json)" = 3 ] || fail "seed $seed has $(grep -c reached_s F$seed/summary.json) checkpoints"
done
expect 0 'Completed' "$FULCRUM" run free/scenario.yaml --headless --hand expert --set seed=8 --out again
cmp F8/trace.csv again/trace.csv || fail "a seed gives two tasks"
[ "$(cat F?/summary.json | grep -A1 '"name"' | grep -c '"above"')" -lt 8 ] || fail "nothing is left out for any seed"
expect 0 'bit for bit' "$FULCRUM" replay F3/tape --out FR
diff <(sed -n '/"checkpoints"/,/\]/p' F3/summary.json) <(sed -n '/"checkpoints"/,/\]/p' FR/summary.json) || fail "a replay has another task"

# --- what is not named is not judged, and explain says so
expect_each 0 'ways .*no checkpoint has a line or a bore' 'trespasses .*no place is to be avoided' -- "$FULCRUM" explain free/scenario.yaml

exit $((failures > 0))
