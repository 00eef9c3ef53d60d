#!/usr/bin/env bash
# The window under a display without a screen: it shows a picture, a drag moves the tool, a push shows force, Esc stops
# and is a pause, F2, F3 and F7 hide and show what they say, it survives being resized and minimised, and it closes. $FULCRUM
# is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
. "$(dirname "$(readlink -f "$0")")/../support/hand_to_pixel.sh"
start_display

open_window piping --validate --size 640x360 --set time_limit=3600 --out "$work/W"
xdotool windowactivate --sync "$window"
runs "$work/W" || fail "it does not run: $(cat "$work/said")"

# A picture: more than a few colours.
coloured() { shot "$1" && [ "$(identify -format %k "$work/$1.png")" -gt 200 ]; }
until_seen coloured before || fail "the window shows no picture"

# accent WxH+X+Y: there is the blue of rings and switches in that part of the window.
accent() {
  shot part
  [ "$(convert "$work/part.png" -crop "$1" +repage -fuzz 8% -fill black +opaque 'rgb(84,164,255)' -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
no_accent() { ! accent "$1"; }

# The way to the first checkpoint is shown from the beginning, and F2 hides it and shows it again.
ring=60x60+261+144
until_seen accent $ring || fail "no ring is around the checkpoint"
xdotool key --window "$window" F2
until_seen no_accent $ring || fail "F2 does not hide the ring"
xdotool key --window "$window" F2
until_seen accent $ring || fail "F2 does not show the ring again"

# F3 shows the haptic thread's figures: the panel below them, with the ghost's switch, moves down and up again.
switch=24x14+476+106 lower=24x14+476+181
until_seen accent $switch || fail "no switch is below the device"
xdotool key --window "$window" F3
until_seen accent $lower || fail "F3 does not show the figures"
xdotool key --window "$window" F3
until_seen accent $switch || fail "F3 does not hide the figures again"

# F7 shows the scene once more in a frame at the lower right, and hides it again.
framed() {
  shot part
  [ "$(convert "$work/part.png" -crop 30x48+455+249 +repage -fuzz 6% -fill black +opaque 'rgb(158,169,182)' -fill white -opaque 'rgb(158,169,182)' -scale 30x1! -format '%[fx:maxima > 0.5]' info:)" = 1 ]
}
not_framed() { ! framed; }
until_seen not_framed || fail "there is a frame before F7"
xdotool key --window "$window" F7
until_seen framed || fail "F7 shows no second view"
xdotool key --window "$window" F7
until_seen not_framed || fail "F7 does not hide the second view"

# The tool's x, first and now; how hard the coupling pulls, now.
newest() { column "$work/W" "$1" | tail -n 2 | head -n 1; }
started=$(column "$work/W" tool/p/x | head -n 1)
moved() { awk -v a="$started" -v b="$(newest tool/p/x)" -v d="$1" 'BEGIN { exit !((b - a) ^ 2 > d ^ 2) }'; }
# The tool's weight is 1.5 N; a push is far more.
pushes() {
  paste <(newest coupling/force/x) <(newest coupling/force/y) <(newest coupling/force/z) |
    awk '{ exit !(sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2) > 4) }'
}
press() { # BUTTON FROM_X FROM_Y TO_X TO_Y: a drag whose button stays down
  xdotool mousemove --sync --window "$window" "$2" "$3" mousedown "$1"
  for step in 1 2 3 4 5 6 7 8; do
    xdotool mousemove --window "$window" $(($2 + ($4 - $2) * step / 8)) $(($3 + ($5 - $3) * step / 8))
  done
}

press 1 300 150 340 150
until_seen moved 0.01 || fail "the drag did not move the tool"
xdotool mouseup 1
for _ in $(seq 32); do xdotool click 4; done # a step is a checkpoint's radius, 10 mm
runs "$work/W"
press 1 340 150 460 150 # against the pipe beside it, and held there
until_seen pushes || fail "the push showed no force"
shot pushed
xdotool mouseup 1

# The mouse as a device has no motors, so the ghost is the one cue: by its key, then by its switch.
ghost() { [ "$(newest torque_substitution/ghost_gain)" = "$1" ]; }
xdotool key --window "$window" F1
xdotool key --window "$window" g
until_seen ghost 0 || fail "G does not switch the ghost off"
# The list of keys takes all presses while it is there, and F1 turns its pages; the switch listens once the panel is back,
# and so is the ring.
until_seen no_accent $ring || fail "F1 shows no list of keys"
xdotool key --window "$window" F1
until_seen accent $ring || fail "F1 does not close the list of keys"
xdotool mousemove --window "$window" 488 113 click 1
until_seen ghost 1 || fail "the ghost's switch does not switch it on"

# size_is W H: the window's, as its manager has it.
size_is() { xdotool getwindowgeometry "$window" | grep -q "Geometry: $1x$2"; }
xdotool windowsize "$window" 800 500
until_seen size_is 800 500 || fail "it cannot be resized"
until_seen coloured resized || fail "no picture after it was resized"
hidden() { ! xdotool search --all --onlyvisible --pid $program --name '^Fulcrum' >/dev/null 2>&1; }
xdotool windowminimize "$window"
until_seen hidden || fail "it cannot be minimised"
runs "$work/W" || fail "it rests while it is minimised"
xdotool windowmap "$window"
xdotool windowactivate --sync "$window"
until_seen coloured mapped || fail "no picture after it was minimised"
kill -0 $program 2>/dev/null || fail "the program ended: $(cat "$work/said")"

stopped() { [ $(($(newest fault) % 2)) = 1 ] || column "$work/W" fault | awk '$1 % 2 == 1 { found = 1 } END { exit !found }'; }
xdotool key Escape
until_seen stopped || fail "Esc did not stop"
red() { # the banner across
  shot banner 60x40+20+130
  [ "$(convert "$work/banner.png" -scale 1x1 -format '%[fx:r > 0.5 && g < 0.35]' info:)" = 1 ]
}
until_seen red || fail "no banner says that it stopped"
shot stopped
[ -z "${FULCRUM_PICTURES-}" ] || cp "$work"/*.png "$FULCRUM_PICTURES"
xdotool key --clearmodifiers alt+F4
wait_for_end
[ $code = 3 ] || fail "exit $code, not 3: $(cat "$work/said")"
column "$work/W" contact/depth_max | awk '$1 > m { m = $1 } END { exit !(m > 0) }' || fail "the push touched nothing"
column "$work/W" torque_substitution/ghost_gain | uniq | head -n 3 | tr '\n' ' ' | grep -q '^1 0 1 $' || fail "the ghost was not switched off and on"
[ -s "$work/W/frame.png" ] || fail "no frame.png"
has_hand_to_pixel "$work/W" 10 || fail "how old the tool was when it was seen is not told: $(grep -A 28 hand_to_pixel "$work/W/summary.json")"
grep -q 'From hand to pixel' "$work/W/report.html" || fail "the report does not tell how old the tool was when it was seen"
grep -q 'Picture, trace, summary and report lie in' "$work/said" || fail "it does not say where the results lie"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
