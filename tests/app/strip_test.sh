#!/usr/bin/env bash
# fulcrum strip from outside: a line through presses at known places. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# The strip of freedom6s, 30 to 170 mm, off by 20 ohm at its beginning and by -300 ohm at its end.
printf 'place_m,ohm\n0.03,120\n0.1,4910\n0.17,9700\r\n\n' > presses.csv
expect 0 'low_ohm: 120' "$FULCRUM" strip presses.csv
expect 0 'high_ohm: 9700' "$FULCRUM" strip presses.csv --device freedom6s
expect 0 '3 presses lie .*mm rms' "$FULCRUM" strip presses.csv
expect 0 'high_ohm: 9700' "$FULCRUM" strip presses.csv --device strip
printf '0.03,120\n0.1,6000\n0.17,9700\n' > bent.csv
expect 0 'more than a finger errs' "$FULCRUM" strip bent.csv

printf '0.03, 120\n0.1,  4910\n0.17, 9700\n' > spaced.csv
expect 0 'low_ohm: 120' "$FULCRUM" strip spaced.csv
printf '0.1,1000\n0.17,9700\n' > negative.csv
expect 1 'negative.csv: by these presses the strip would have -[0-9.]+ ohm' "$FULCRUM" strip negative.csv
[ -z "$("$FULCRUM" strip negative.csv 2>/dev/null)" ] || fail "a negative end is written for the device's file"

printf '0.03,120\n0.05;1500\n' > bad.csv
expect 1 'bad.csv, line 2: this is not a press' "$FULCRUM" strip bad.csv
printf '0.03,120\n0.1,inf\n' > open.csv
expect 1 'open.csv, line 2' "$FULCRUM" strip open.csv
printf '0.05,120\n0.05,130\n' > one.csv
expect 1 'two places' "$FULCRUM" strip one.csv
expect 1 'cannot be read' "$FULCRUM" strip gone.csv
expect 1 'has no strip' "$FULCRUM" strip presses.csv --device w6d
expect 1 "no device 'freedom'" "$FULCRUM" strip presses.csv --device freedom
expect 2 'presses' "$FULCRUM" strip

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
