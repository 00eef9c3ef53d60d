#!/usr/bin/env bash
# A window for two eyes under a display without a screen: both halves show the scene and its panels, a drag and a press
# in either do what they do where there is one, it can be resized, and it closes. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display

open_window piping --stereo side-by-side --validate --size 640x360 --set time_limit=3600 --out "$work/W"
xdotool windowactivate --sync "$window"
runs "$work/W" || fail "it does not run: $(cat "$work/said")"

# accent WxH+X+Y: there is the blue of rings and switches in that part of the window.
accent() {
  shot part
  [ "$(convert "$work/part.png" -crop "$1" +repage -fuzz 12% -fill black +opaque 'rgb(84,164,255)' -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
no_accent() { ! accent "$1"; }

# The ring around the first checkpoint, which F2 hides for both eyes.
rings=(30x60+130+144 30x60+450+144)
for ring in "${rings[@]}"; do until_seen accent "$ring" || fail "no ring is around the checkpoint at $ring"; done
xdotool key --window "$window" F2
for ring in "${rings[@]}"; do until_seen no_accent "$ring" || fail "F2 does not hide the ring at $ring"; done

newest() { column "$work/W" "$1" | tail -n 2 | head -n 1; }
started=$(column "$work/W" tool/p/x | head -n 1)
moved() { awk -v a="$started" -v b="$(newest tool/p/x)" -v d="$1" 'BEGIN { exit !((b - a) ^ 2 > d ^ 2) }'; }
xdotool mousemove --sync --window "$window" 470 150 mousedown 1
for x in 474 478 482 486 490; do xdotool mousemove --window "$window" $x 150; done
until_seen moved 0.01 || fail "a drag in the right half did not move the tool"
xdotool mouseup 1

# The ghost's switch, in the right half and then in the left one.
ghost() { [ "$(newest torque_substitution/ghost_gain)" = "$1" ]; }
xdotool mousemove --window "$window" 564 113 click 1
until_seen ghost 0 || fail "the switch in the right half does not switch the ghost off"
xdotool mousemove --window "$window" 244 113 click 1
until_seen ghost 1 || fail "the switch in the left half does not switch it on"

# Once more by F7, in a frame at the lower right of either half.
framed() { # X
  shot part
  [ "$(convert "$work/part.png" -crop "15x48+$1+249" +repage -fuzz 8% -fill black +opaque 'rgb(158,169,182)' -fill white -opaque 'rgb(158,169,182)' -scale 15x1! -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
xdotool key --window "$window" F7
for x in 227 547; do until_seen framed $x || fail "F7 shows no second view at $x"; done
[ -z "${FULCRUM_PICTURES-}" ] || cp "$work"/part.png "$FULCRUM_PICTURES/stereo.png"

xdotool windowsize "$window" 801 501
size_is() { xdotool getwindowgeometry "$window" | grep -q "Geometry: $1x$2"; }
until_seen size_is 801 501 || fail "it cannot be resized"
runs "$work/W" || fail "it rests after it was resized"
xdotool key --clearmodifiers alt+F4
wait_for_end
[ $code = 3 ] || fail "exit $code, not 3: $(cat "$work/said")"
[ "$(identify -format '%wx%h' "$work/W/frame.png")" = 801x501 ] || fail "frame.png is not the window's"

# The slider of the holding point is drawn beyond the middle of the window: it stays at its end, in the half where it was taken.
open_window stick --stereo side-by-side --mute --size 1280x720 --set time_limit=3600 --out "$work/S"
xdotool windowactivate --sync "$window"
runs "$work/S" || fail "stick does not run: $(cat "$work/said")"
place() { column "$work/S" holding_point/place | tail -n 2 | head -n 1; }
at_end() { awk -v p="$(place)" 'BEGIN { exit !(p > 0.169) }'; }
xdotool mousemove --sync --window "$window" 577 231 mousedown 1
for x in 590 605 620 632; do xdotool mousemove --window "$window" $x 231; done
until_seen at_end || fail "the slider is not drawn to its end: $(place)"
for x in 638 644 650 660; do xdotool mousemove --window "$window" $x 231; done
runs "$work/S" 1500
at_end || fail "the slider leaps where the pointer leaves its half: $(place)"
xdotool mouseup 1
xdotool key --clearmodifiers alt+F4
wait_for_end

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
