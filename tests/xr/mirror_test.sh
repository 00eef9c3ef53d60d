#!/usr/bin/env bash
# A headset's mirror under a display without a screen: it shows what the left eye sees, Esc stops and Enter goes on, it can
# be resized, and closing it ends the run in order, and so does a display that is lost. $FULCRUM is the program, $RUNTIME the manifest of the tests' runtime.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display
export XR_RUNTIME_JSON=$RUNTIME FULCRUM_XR_SCRIPT=$work/script FULCRUM_XR_LOG=$work/log
printf '%s\n' 'size 240 320' 'pace 5' >"$work/script"
. "$(dirname "$(readlink -f "$0")")/layer.sh"

open_window piping --xr --mute --validate --device simulated --set dwell=600 --set time_limit=3600 --size 480x360 --out "$work/W"
[ "$(xdotool getwindowgeometry "$window" | grep -o '[0-9]*x[0-9]*$')" = 270x360 ] || fail "the mirror has not an eye's shape"
# The pipes are painted orange; no panel is.
orange() {
  shot seen
  [ "$(convert "$work/seen.png" -fuzz 15% -fill black +opaque 'rgb(200,150,40)' -format '%[fx:mean > 0.001]' info:)" = 1 ]
}
until_seen orange || fail "the mirror does not show the pipes"
[ -z "${FULCRUM_PICTURES-}" ] || cp "$work/seen.png" "$FULCRUM_PICTURES/mirror.png"
stops() { column "$work/W" fault | awk '$1 % 2 { n += !was } { was = $1 % 2 } END { print n + 0, was + 0 }'; }
stopped() { [ "$(stops)" = "1 1" ]; }
goes_on() { [ "$(stops)" = "1 0" ]; }
until_seen runs "$work/W" 1 || fail "it does not run"
xdotool key --window "$window" Escape
until_seen stopped || fail "Esc stops nothing: $(stops)"
xdotool key --window "$window" Return
until_seen goes_on || fail "Enter does not go on: $(stops)"
# Minimised, it holds no picture of the headset back: there are as many a tick as before.
frames() { grep -c '^xrAcquireSwapchainImage' "$work/log"; }
ticks() { wc -l <"$work/W/trace.csv"; }
pace() { # frames in a million ticks, from 4000 of them; where none come, nothing
  local frame tick
  frame=$(frames) tick=$(ticks)
  passed() { [ "$(ticks)" -gt $((tick + 4000)) ]; }
  until_seen passed && echo $((1000000 * ($(frames) - frame) / ($(ticks) - tick)))
}
shown=$(pace)
xdotool windowminimize "$window"
iconic() { xprop -id "$window" WM_STATE 2>/dev/null | grep -q Iconic; }
until_seen iconic || fail "the mirror cannot be minimised"
keeps_pace() { # as good as before; what else the machine does may disturb one measure, and not three
  hidden=$(pace)
  [ -n "$hidden" ] && [ -n "$shown" ] && [ $((4 * hidden)) -ge $((3 * shown)) ]
}
keeps_pace || keeps_pace || keeps_pace || fail "a minimised mirror takes pictures from the headset: $hidden of $shown"
xdotool windowmap "$window" windowactivate "$window"
xdotool windowsize "$window" 400 300
until_seen orange || fail "the mirror shows nothing once it is resized"
# A display that does not answer for 7 s, where 5 s are what it may, stops the force; whom nobody holds goes on by itself.
jams() { grep -c 'the display of the mirror did not answer in time: the force is off' "$work/said"; }
jammed() { [ "$(jams)" = 1 ]; }
kill -STOP $xvfb
sleep 7
kill -CONT $xvfb
until_seen jammed || fail "the force stays on while the mirror's display does not answer: $(cat "$work/said")"
stops() { column "$work/W" fault | awk '{ now = int($1 / 64) % 2; n += now && !was; was = now } END { print n + 0, was + 0 }'; } # unanswered
until_seen goes_on || fail "the force is not back, or went more than once: $(stops)"
grep -q '^WRONG' "$work/log" && fail "the runtime was called wrongly: $(grep -m 3 '^WRONG' "$work/log")"
xdotool key --clearmodifiers alt+F4
wait_for_end
[ $code = 3 ] || fail "exit $code, not 3: $(cat "$work/said")"
[ ! -s "$work/messages" ] || fail "the validation layer says: $(head -5 "$work/messages")"
[ -z "${XR_ENABLE_API_LAYERS-}" ] || grep -q 'Core Validation output' "$work/said" || fail "the validation layer was not there"
grep -q '^xrDestroyInstance' "$work/log" || fail "the instance is not destroyed"
[ "$(identify -format '%wx%h' "$work/W/frame.png")" = 480x320 ] || fail "frame.png is the mirror's, and not both eyes'"

# The display is lost: the run ends in order, and says why.
printf '%s\n' 'size 64 64' 'pace 10' >"$work/script"
open_window piping --xr --mute --device simulated --set dwell=600 --set time_limit=3600 --out "$work/L"
runs "$work/L" 100 || fail "it does not run before its display is lost"
kill -9 $xvfb
wait_for_end
[ $code = 3 ] || fail "exit $code, not 3, once the display is lost: $(cat "$work/said")"
grep -q "^fulcrum: the mirror's window is gone, for its X server ended or another program closed it: the run ends here" "$work/said" ||
  fail "it does not say why it ends: $(cat "$work/said")"
[ -s "$work/L/summary.json" ] || fail "what was recorded is not kept"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
