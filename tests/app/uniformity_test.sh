#!/usr/bin/env bash
# fulcrum uniformity from outside: its files, what they say, what it refuses. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

expect 0 'Method 2 .*just noticeable: 8 %' "$FULCRUM" uniformity --out D
case $(head -1 D/uniformity.csv) in
  method,place_m,assigned_stiffness_N_per_m,felt_stiffness_N_per_m,felt_torque_error_Nm,*) ;;
  *) fail "uniformity.csv has other columns: $(head -1 D/uniformity.csv)" ;;
esac
for method in none arm acceleration; do
  [ "$(grep -c "^$method," D/uniformity.csv)" = 66 ] || fail "$method has not 11 places on 6 balls"
done
# Mean |f_h - f| at most 8 % of f along the whole stick; torque within 12.7 % or 8 mN m.
awk -F, '$1 == "acceleration" { d = $4 / $3 - 1; t = .127 * ($8 < 0 ? -$8 : $8); if (t < .008) t = .008
  if (d > .08 || d < -.08 || $5 > t || $5 < -t) { print; bad = 1 } } END { exit bad }' D/uniformity.csv || fail "method 2 is off"
# Uncompensated: K - m a / x, the tremor's mean apart.
awk -F, '$1 == "none" { d = $3 - $4 - .25 / .00304; if (d > 12 || d < -12) { print; bad = 1 } } END { exit bad }' D/uniformity.csv ||
  fail "uncompensated is not what the formula says"
[ "$(head -1 D/filter.csv | cut -d, -f1-3)" = filter,jerk_m_per_s3_per_rtHz,lag_s ] || fail "filter.csv has other columns"
grep -q '</html>' D/uniformity.html || fail "no uniformity.html"
[ "$(grep -o '<svg' D/uniformity.html | wc -l)" -ge 8 ] || fail "uniformity.html lacks plots"
grep -q 'fulcrum uniformity' D/uniformity.html || fail "uniformity.html does not say how it was made"
if grep -qi 'nan\b' D/uniformity.csv D/filter.csv; then fail "a table holds what is not a number"; fi

expect 1 'holds results.*--force' "$FULCRUM" uniformity --out D
expect 0 'Method 2' "$FULCRUM" uniformity --out D --force
expect 2 'strikes' "$FULCRUM" uniformity --strikes 3

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
