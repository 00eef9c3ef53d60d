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

# While the scenario is read or baked, for a cache of the test's own.
before_it_is_ready() { # SENTENCE COMMAND...
  XDG_CACHE_HOME=$work/cache open_window piping --size 320x180 --set field.voxel=0.0003 --out "$work/none"
  "${@:2}"
  wait_for_end
  [ $code = 3 ] || fail "while it bakes: exit $code: $(cat "$work/said")"
  grep -q "^fulcrum: $1" "$work/said" || fail "while it bakes: says $(cat "$work/said")"
  [ ! -e "$work/none" ] || fail "while it bakes: something was run"
}
before_it_is_ready 'interrupted before the trial began: nothing was run\.$' eval 'kill -INT $program'
before_it_is_ready 'the window was closed before the scenario was ready: nothing was run\.$' eval 'xdotool windowclose "$window"'

run_one no_server
kill $xvfb
ended_in_order no_server
grep -q 'the window is gone' "$work/said" || fail "no_server: does not say so: $(cat "$work/said")"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
