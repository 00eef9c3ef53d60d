#!/usr/bin/env bash
# fulcrum compare from outside: its files, what agrees with a run, what it refuses. $FULCRUM is the program; with the
# argument 'long', 20 trials of each variant instead.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted

# cell FILE METRIC VARIANT COLUMN
cell() { awk -F, -v m="$2" -v v="$3" -v c="$4" '$1 == m && $2 == v { print $c }' "$1"; }
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b != "" && a + 0 < b + 0) }'; }

if [ "${1:-}" = long ]; then
  expect 0 'finding about people' "$FULCRUM" compare piping --variants A,B,C --hand yielding --trials 20 --out D
  for variant in B C; do
    below "$(cell D/compare.csv E_tau $variant 6)" "$(cell D/compare.csv E_tau A 5)" ||
      fail "E_tau of $variant is not below that of A with intervals apart: $(cat D/compare.csv)"
    [ "$(cell D/compare.csv t_c $variant 3)" = 20 ] || fail "not every trial of $variant completed"
  done
  [ $failures = 0 ] && echo "all good"
  exit $((failures > 0))
fi

# --- the files
expect 0 'finding about people' "$FULCRUM" compare piping --variants A,B,C --hand yielding --trials 2 --out D
[ "$(head -1 D/compare.csv)" = metric,variant,n,mean,low,high ] || fail "compare.csv has other columns"
[ "$(grep -cE '^(E_tau|E_F|t_c),[ABC],2,' D/compare.csv)" = 9 ] || fail "compare.csv: $(cat D/compare.csv)"
for variant in B C; do
  below "$(cell D/compare.csv E_tau $variant 4)" "$(cell D/compare.csv E_tau A 4)" || fail "E_tau of $variant is not below A's"
done
grep -q '"reaction_s": 0.25' D/compare.json || fail "compare.json does not say how fast the hand reacts"
[ "$(grep -c '"seed": 2' D/compare.json)" = 3 ] || fail "compare.json has not every variant's second trial"
grep -q '</html>' D/compare.html || fail "no compare.html"
grep -q 'Nothing here is a finding about people' D/compare.html || fail "compare.html claims too much"
expect 1 'holds results.*--force' "$FULCRUM" compare piping --trials 2 --out D
expect 0 'finding about people' "$FULCRUM" compare piping --trials 2 --out D2
cmp -s D/compare.json D2/compare.json || fail "the defaults are other variants or another hand, or two comparisons differ"

# --- a trial is a run, and a recorded motion is the same run again
"$FULCRUM" run piping --headless --hand yielding --set variant=A --out A >/dev/null 2>&1 || fail "the hand does not complete"
ran=$(sed -nE 's/.*"torque_error_Nms": ([^,]*),.*/\1/p' A/summary.json)
expect 0 'finding about people' "$FULCRUM" compare piping --variants A --hand yielding --trials 1 --out E
[ "$(cell E/compare.csv E_tau A 4)" = "$ran" ] || fail "E_tau of a trial is not the run's: $ran, $(cat E/compare.csv)"
expect 0 'cannot yield' "$FULCRUM" compare piping --tape A/tape --out F
for variant in A B C; do
  grep -qxF "E_tau,$variant,1,$ran,," F/compare.csv || fail "the same motion has another E_tau under $variant: $(cat F/compare.csv)"
done

# --- a hand that does not yield
expect 0 'does not yield' "$FULCRUM" compare piping --variants A,C --hand expert --trials 1 --out G
expect 0 '"yields": null' "$FULCRUM" compare piping --variants A --hand expert --trials 1 --json --out H

# --- what it refuses
expect 1 "no hand 'nobody'.*yielding" "$FULCRUM" compare piping --hand nobody --out X
expect 1 "no hand 'yeilding'; did you mean 'yielding'" "$FULCRUM" compare piping --hand yeilding --out X
expect 1 'nothing.tape' "$FULCRUM" compare piping --tape nothing.tape --out X
[ ! -e X ] || fail "a refused comparison leaves a folder"
expect 2 "no variant 'D'" "$FULCRUM" compare piping --variants A,D
expect 2 'named twice' "$FULCRUM" compare piping --variants A,B,A
expect 2 'no variant is named' "$FULCRUM" compare piping --variants ''
expect 2 'trials' "$FULCRUM" compare piping --trials 0
expect 2 'excludes' "$FULCRUM" compare piping --tape A/tape --hand yielding
content=$(dirname "$FULCRUM")/content
mkdir scenarios
cp -r "$content/scenarios/piping" scenarios/
mkdir scenarios/piping/devices
sed -i '/^torque_substitution/d' scenarios/piping/scenario.yaml
expect 1 "does not name torque_substitution.*add 'torque_substitution" "$FULCRUM" compare scenarios/piping/scenario.yaml --out X
cp "$content/scenarios/piping/scenario.yaml" scenarios/piping/
sed 's/^kinematics:.*/kinematics: cartesian/; s/^renders_torque:.*/renders_torque: true/; s/^max_torque:.*/max_torque: 0.5/' \
  "$content/devices/phantom_like.yaml" >scenarios/piping/devices/torque_arm.yaml
sed -i 's/model: phantom_like/model: torque_arm/' scenarios/piping/scenario.yaml
expect 1 'nothing to substitute' "$FULCRUM" compare scenarios/piping/scenario.yaml --out X

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
