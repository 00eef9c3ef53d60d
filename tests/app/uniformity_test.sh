#!/usr/bin/env bash
# fulcrum uniformity from outside: its files, what they say, what it refuses. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

"$FULCRUM" uniformity --out D > said || fail "fulcrum uniformity: exit $?"
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
# within FIGURE WHAT LOW HIGH: a figure that was said, and whether it is there at all.
within() {
  awk -v x="$1" -v low="$3" -v high="$4" 'BEGIN { exit !(x != "" && x + 0 >= low && x + 0 <= high) }' ||
    fail "$2: '$1' is not from $3 to $4: $(cat said)"
}
# worst METHOD: the largest error of the mean stiffness in the table, in percent.
worst() {
  awk -F, -v m="$1" '$1 == m { d = 100 * ($4 / $3 - 1); if (d < 0) d = -d; if (d > w) w = d } END { print w }' D/uniformity.csv
}
number='[-+.e0-9]+'
formulas=$(sed -nE "s/^Uncompensated, .*predict, to ($number) % .*/\1/p" said)
within "$formulas" 'the formulas in percent' 0 1
within "$(sed -nE "s/^Uncompensated, stiffness is off by up to ($number) % .*/\1/p" said)" 'uncompensated' \
  "$(worst none | awk '{ print $1 * .99 }')" "$(worst none | awk '{ print $1 * 1.01 }')"
within "$(sed -nE "s/^Method 1 .* jumps by up to ($number) mN m .*/\1/p" said)" "method 1's jump" 150 230
method2=$(grep '^Method 2' said)
within "$(sed -nE "s/.*stiffness is off by up to ($number) % .*/\1/p" <<<"$method2")" 'method 2' \
  "$(worst acceleration | awk '{ print $1 * .98 }')" "$(worst acceleration | awk '{ print $1 * 1.02 }')"
within "$(sed -nE "s/.*does not jump at the hand: ($number) mN m at most.*/\1/p" <<<"$method2")" "method 2's jump" 0 1
grep -qE 'exact to ([0-9.]+·)?10⁻¹[^.]*\.$' <<<"$method2" || fail "with the true acceleration it is not exact: $method2"
within "$(sed -nE "s/.*scatters by ($number) % on 600 N\/m .*/\1/p" said)" 'scatter, stiffest' 0.5 3
within "$(sed -nE "s/.*and by ($number) % on 100 N\/m .*/\1/p" said)" 'scatter, softest' 4 15

[ "$(head -1 D/filter.csv | cut -d, -f1-3)" = filter,jerk_m_per_s3_per_rtHz,lag_s ] || fail "filter.csv has other columns"
grep -q '</html>' D/uniformity.html || fail "no uniformity.html"
[ "$(grep -o '<svg' D/uniformity.html | wc -l)" -ge 8 ] || fail "uniformity.html lacks plots"
grep -q 'fulcrum uniformity' D/uniformity.html || fail "uniformity.html does not say how it was made"
if grep -qi 'nan\b' D/uniformity.csv D/filter.csv; then fail "a table holds what is not a number"; fi

expect 1 'holds results.*--force' "$FULCRUM" uniformity --out D
expect 2 'strikes' "$FULCRUM" uniformity --strikes 3

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
