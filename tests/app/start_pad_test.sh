#!/usr/bin/env bash
# A whole session by a gamepad alone, an Xbox pad that umockdev stands in for, under a display without a screen: from the
# start page the device's test, a trial on the device `gamepad`, a stop, another try, and the way back to the start page. $FULCRUM is the program, $PAD plays the pad.
set -uo pipefail
support=$(dirname "$(readlink -f "$0")")/../support
. "$support/display.sh"
start_display
export XDG_DATA_HOME=$work/data XDG_CONFIG_HOME=$work/config
. "$support/start_page.sh"
unhurried stick
. "$support/pad.sh"
# now RUN NAME: of the newest tick that is written whole.
now() { column "$1" "$2" | tail -n 2 | head -n 1; }

# The first bar of the device's test, to either side of its middle.
pushed() { accent "$([ "$1" = right ] && echo 90x6+660+241 || echo 90x6+554+241)"; }

"$PAD" "$pad" "$FULCRUM" devices >"$work/devices" 2>&1
sed '/^Not there/,$d' "$work/devices" | grep -q '^  gamepad ' || fail "devices does not list the gamepad: $(cat "$work/devices")"

start_fulcrum "$PAD" "$pad"
stick=$(place stick)
until_seen scenario_focused 0 || fail "the first scenario is not in focus"
for ((i = 0; i < stick; ++i)); do tap down; done
until_seen scenario_focused "$stick" || fail "the cross does not reach the stick"
picture start

# --- the device's test shows what is pushed, and B closes it
tap left_bumper # nothing to a menu
for ((i = stick; i < ${#scenes[@]} + 1; ++i)); do tap down; done
until_seen setting_focused 1 || fail "the cross does not reach the device"
tap a
say left_x 1
say a 1
until_seen pushed right || fail "the test does not show the stick pushed to the right"
picture tested
say left_x -1
until_seen pushed left || fail "the test does not show the stick pushed to the left"
say left_x 0
say a 0
tap b
until_seen setting_focused 1 || fail "B does not close the device's test"
tap b # to the scenarios again, of which the last one is the nearest
for ((i = stick; i < ${#scenes[@]} - 1; ++i)); do tap up; done
until_seen scenario_focused "$stick" || fail "B does not lead back to the scenarios"
tap a
until_seen began stick || fail "nothing was started: $(cat "$work/said")"
run=$(newest stick)
runs "$run" || fail "it does not run: $(cat "$work/said")"
grep -q '"device": "gamepad"' "$work/config/fulcrum/start.json" || fail "the pad is not the device that is taken"

# --- the tool goes as the stick is pushed, and rests when it is let go
moved() { awk -v a="$from" -v b="$(now "$run" handle/p/x)" 'BEGIN { exit !((b - a) ^ 2 > 0.005 ^ 2) }'; }
from=$(now "$run" handle/p/x)
say left_x 0.7
until_seen moved || fail "the left stick does not move the tool"
say left_x 0

# --- nothing is thrown away by a slip; B stops, A goes on
tap y back b
stopped() { [ $(($(now "$run" fault) % 2)) = 1 ]; }
goes() { ! stopped; }
banner_is_there() { # red, across
  shot banner 120x60+20+190
  [ "$(convert "$work/banner.png" -scale 1x1 -format '%[fx:r > 0.5 && g < 0.35]' info:)" = 1 ]
}
until_seen stopped || fail "B does not stop"
until_seen banner_is_there || fail "no banner says that it stopped"
picture stopped
tap a
until_seen goes || fail "A does not go on"
[ "$(newest stick)" = "$run" ] || fail "Y starts again in the midst of a trial"
tap x
until_seen shows_keys || fail "X does not list what keys and buttons do"
picture keys
tap x right
until_seen shows_no_keys || fail "X does not put the list away"

# --- Y starts again once it is stopped
tap b
until_seen stopped || fail "B does not stop again"
tap y
until_seen another stick "$run" || fail "Y does not start again"
run=$(newest stick)
runs "$run" || fail "the second attempt does not run"

# --- and Back goes to the start page, once it is stopped
tap b
until_seen stopped || fail "B does not stop the second attempt"
tap back
until_seen scenario_focused "$stick" || fail "Back does not go to the start page"
tap b
wait_for_end
[ "$code" = 0 ] || fail "it ended with $code: $(cat "$work/said")"

[ "$failures" = 0 ] || exit 1
echo "all good"
