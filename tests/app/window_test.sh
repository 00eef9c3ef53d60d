#!/usr/bin/env bash
# The window under a display without a screen: it shows a picture, a drag moves the tool, a push shows force, Esc stops,
# it survives being resized and minimised, and it closes. $FULCRUM is the program.
set -uo pipefail
for command in Xvfb openbox xdotool import; do command -v $command >/dev/null || { echo "skipped: no $command"; exit 77; }; done
work=$(mktemp -d)
exec {pipe}<> <(:)
Xvfb -displayfd $pipe -screen 0 1280x800x24 >/dev/null 2>&1 &
xvfb=$!
read -r -u $pipe number || exit 1
export DISPLAY=:$number
openbox >/dev/null 2>&1 &
trap 'kill $xvfb 2>/dev/null; rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

"$FULCRUM" run piping --validate --size 640x360 --set time_limit=600 --out "$work/W" >"$work/said" 2>&1 &
program=$!
window=
for _ in $(seq 120); do
  window=$(xdotool search --onlyvisible --name '^Fulcrum' 2>/dev/null | head -n 1)
  [ -n "$window" ] && break
  sleep 0.5
done
[ -n "$window" ] || { cat "$work/said"; echo "FAILED: no window"; exit 1; }
xdotool windowactivate --sync "$window"
sleep 4

# A picture: more than a few colours.
import -window "$window" "$work/before.png"
[ "$(identify -format %k "$work/before.png")" -gt 200 ] || fail "the window shows no picture"

press() { # BUTTON FROM_X FROM_Y TO_X TO_Y: a drag whose button stays down
  xdotool mousemove --window "$window" "$2" "$3" mousedown "$1"
  for step in 1 2 3 4 5 6 7 8; do
    xdotool mousemove --window "$window" $(($2 + ($4 - $2) * step / 8)) $(($3 + ($5 - $3) * step / 8))
    sleep 0.1
  done
}
press 1 300 150 340 150
xdotool mouseup 1
for _ in $(seq 80); do xdotool click 4; sleep 0.05; done
press 1 340 150 460 150 # against the pipe beside it, and held there
sleep 2
import -window "$window" "$work/pushed.png"
xdotool mouseup 1
xdotool key --window "$window" F1
sleep 1
# The mouse as a device has no motors, so the ghost is the one cue: by its key, then by its switch.
xdotool key --window "$window" g
sleep 1
xdotool mousemove --window "$window" 488 149 click 1
sleep 1
xdotool windowsize --sync "$window" 800 500
sleep 1
xdotool windowminimize --sync "$window"
sleep 1
xdotool windowmap --sync "$window"
xdotool windowactivate --sync "$window"
sleep 1
kill -0 $program 2>/dev/null || fail "the program ended: $(cat "$work/said")"
xdotool key Escape
sleep 2
import -window "$window" "$work/stopped.png"
[ -z "${FULCRUM_PICTURES-}" ] || cp "$work"/*.png "$FULCRUM_PICTURES"
xdotool key --clearmodifiers alt+F4
for _ in $(seq 60); do
  kill -0 $program 2>/dev/null || break
  sleep 0.5
done
kill -0 $program 2>/dev/null && fail "the window did not close" && kill -9 $program
wait $program
code=$?
[ $code = 3 ] || fail "exit $code, not 3: $(cat "$work/said")"

# column NAME: its values.
column() { awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } { print $c }' "$work/W/trace.csv"; }
column tool/p/x | awk 'NR == 1 { a = b = $1 } { if ($1 < a) a = $1; if ($1 > b) b = $1 } END { exit !(b - a > 0.01) }' || fail "the drag did not move the tool"
column contact/depth_max | awk '$1 > m { m = $1 } END { exit !(m > 0) }' || fail "the push touched nothing"
# The tool's weight is 1.5 N; a push is far more, until Esc.
paste <(column coupling/force/x) <(column coupling/force/y) <(column coupling/force/z) |
  awk '{ f = sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2); if (f > m) m = f } END { exit !(m > 4) }' || fail "the push showed no force"
column cue/ghost_gain | uniq | tr '\n' ' ' | grep -q '^1 0 1 $' || fail "the ghost was not switched off and on: $(column cue/ghost_gain | uniq | tr '\n' ' ')"
column fault | awk '$1 % 2 == 1 { found = 1 } END { exit !found }' || fail "Esc did not stop"
[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
