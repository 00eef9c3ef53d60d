#!/usr/bin/env bash
# However a window run ends, it ends in order: the terminal hangs up, another program destroys the window or cuts its
# connection, the X server dies. The summary is there, the tape has its end, the picture is there and the code is that of
# a closed window. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display

# ended_in_order FOLDER: after what should have ended it.
ended_in_order() {
  wait_for_end
  [ $code = 3 ] || fail "$1: exit $code, not 3: $(cat "$work/said")"
  for file in summary.json trace.csv tape frame.png; do [ -s "$work/$1/$file" ] || fail "$1: no $file"; done
  grep -q 'Picture, trace, summary and report lie in' "$work/said" || fail "$1: does not say where the results lie: $(cat "$work/said")"
  "$FULCRUM" replay "$work/$1/tape" --out "$work/$1-again" >"$work/replayed" 2>&1
  grep -q 'bit for bit' "$work/replayed" || fail "$1: $(cat "$work/replayed")"
  grep -q 'ends early' "$work/replayed" && fail "$1: the tape has no end"
}

run_one() { # FOLDER
  open_window piping --size 320x180 --set time_limit=3600 --out "$work/$1"
  runs "$work/$1" || fail "$1: does not run"
}

run_one hangup
kill -HUP $program
kill -HUP $program 2>/dev/null # a shell passes it on once more
ended_in_order hangup

run_one destroyed
xdotool windowclose "$window"
ended_in_order destroyed
grep -q 'the window is gone' "$work/said" || fail "destroyed: does not say so: $(cat "$work/said")"

run_one killed
xdotool windowkill "$window"
ended_in_order killed
grep -q 'the window is gone' "$work/said" || fail "killed: does not say so: $(cat "$work/said")"

run_one no_server
kill $xvfb
ended_in_order no_server
grep -q 'the window is gone' "$work/said" || fail "no_server: does not say so: $(cat "$work/said")"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
