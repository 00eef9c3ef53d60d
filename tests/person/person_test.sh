#!/usr/bin/env bash
# person_test.sh SCENE: a scene in a window under a display without a screen, carried out by mouse and keys alone by a
# program that sees nothing but the window's pixels. It has to be completed within twice the expert's time; both are
# judged by the summaries. Where it was not, and fewer pictures a second were shown than the pointer needs, it is skipped: a
# busy machine decides nothing. $FULCRUM is the program, $PERSON the pointer. By hand, from a build folder:
#   FULCRUM=./fulcrum PERSON=tests/fulcrum_person bash ../../tests/person/person_test.sh plate
set -uo pipefail
support=$(dirname "$(readlink -f "$0")")/../support
. "$support/display.sh"
. "$support/session.sh"
scene=$1
time_of() { grep -oP '"completion_time_s": *\K[0-9.]+' "$1/summary.json"; }

"$FULCRUM" run "$scene" --headless --hand expert --out "$work/expert" >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
expert=$(time_of "$work/expert")

start_display 2560x1600
open_window "$scene" --device mouse --size "${FULCRUM_PERSON_SIZE:-640x360}" --out "$work/trial"
xdotool windowactivate --sync "$window"
practise "$scene"
xdotool key --clearmodifiers alt+F4
wait_for_end
if person=$(time_of "$work/trial"); then
  awk -v p="$person" -v e="$expert" 'BEGIN { printf "%.1f s, the expert %.1f s: %.2f times\n", p, e, p / e; exit !(p <= 2 * e) }' ||
    fail "slower than twice the expert"
else
  fail "not completed"
fi
[ $failures = 0 ] && exit 0
! too_slow || skip_too_slow
exit 1
