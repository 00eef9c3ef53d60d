#!/usr/bin/env bash
# fulcrum hardness from outside: its files, its options, what it refuses. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# cell FILE METHOD DIRECTION PHI COLUMN, at home
cell() { awk -F, -v m="$2" -v d="$3" -v p="$4" -v c="$5" '$2 == m && $3 == "home" && $4 == d && $5 == p { print $c }' "$1"; }
near() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; exit !(a != "" && d <= t && -d <= t) }'; }

# --- the files, at the motors' limits of the paper's study
expect 0 'Algorithm 1 finds a moment' "$FULCRUM" hardness --device w6d --motor-limit 0.255 --out D
[ "$(head -1 D/hardness.csv)" = device,method,pose,direction,phi_deg,force_N,moment_Nm,felt_force_N,felt_moment_Nm,extended_rate_hardness_N_per_m,gamma,delta ] ||
  fail "hardness.csv has other columns: $(head -1 D/hardness.csv)"
near "$(cell D/hardness.csv force_only '0 1 0' 45 6)" 1.394 5.1e-4 || fail "force only, up: $(cell D/hardness.csv force_only '0 1 0' 45 6)"
near "$(cell D/hardness.csv force_only_spare '0 1 0' 45 6)" 1.980 5.1e-4 || fail "with the spare motor, up: $(cell D/hardness.csv force_only_spare '0 1 0' 45 6)"
near "$(cell D/hardness.csv force_only '0 0 1' 0 6)" 2.600 5.1e-4 || fail "force only, to the person: $(cell D/hardness.csv force_only '0 0 1' 0 6)"
near "$(cell D/hardness.csv exact '0 0 1' 0 9)" 0 1e-9 || fail "a felt moment at phi = 0"
near "$(cell D/hardness.csv none '0 1 0' 45 10)" 5678 20 || fail "the spring alone has another rate-hardness"
grep -q '</html>' D/hardness.html || fail "no hardness.html"
grep -q 'hardness --device w6d --motor-limit 0.255' D/hardness.html || fail "hardness.html does not say how it was made"
grep -q '"wanted_force_N": 67.5' D/hardness.json || fail "hardness.json does not say what was wanted"
expect 1 'holds results.*--force' "$FULCRUM" hardness --out D

# --- the same again, by default, and another device and speed
expect 0 'Algorithm 1' "$FULCRUM" hardness --device w6d --motor-limit 0.255 --out E
cmp -s D/hardness.csv E/hardness.csv || fail "the same study differs"
expect 0 '"device": "w6d"' "$FULCRUM" hardness --json --out F
expect 0 'Algorithm 1' "$FULCRUM" hardness --device serial6 --speed 0.05 --out G
grep -q '^serial6,exact,home,' G/hardness.csv || fail "no serial6"
expect 0 'renders no torque' "$FULCRUM" hardness --device phantom_like --out H

# --- what it refuses
expect 1 "no device 'w6'; did you mean 'w6d'" "$FULCRUM" hardness --device w6 --out X
expect 1 "no device 'nothing'; there are .*serial6" "$FULCRUM" hardness --device nothing --out X
expect 1 'no arms' "$FULCRUM" hardness --device six_axis --motor-limit 0.2 --out X
[ ! -e X ] || fail "a refused study leaves a folder"
expect 2 'speed' "$FULCRUM" hardness --speed 0
expect 2 'motor-limit' "$FULCRUM" hardness --motor-limit -1

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
