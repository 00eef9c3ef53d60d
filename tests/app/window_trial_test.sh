#!/usr/bin/env bash
# A trial in a window: its time rests while the force is stopped, at its end everything rests, R begins anew where the
# first began, and a drag is as long as the hand likes, not the screen. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display 800x600

open_window piping --size 640x360 --seconds 20 --out "$work/T"
threads() { ls /proc/$program/task | wc -l; }

# --- a pause: the trial of 20 s lasts far longer
until_seen more_rows "$work/T" 100 || fail "it does not run: $(cat "$work/said")"
xdotool windowactivate --sync "$window" key Escape
stopped() { column "$work/${1:-T}" fault | awk '$1 % 2 == 1 { found = 1 } END { exit !found }'; }
until_seen stopped || fail "Esc did not stop"
with=$(threads)
runs "$work/T" 21000 || fail "time goes on while it is stopped: $(rows "$work/T") ticks in all"

# --- while it is stopped, a drag moves nothing
newest() { column "$work/$1" "$2" | tail -n 2 | head -n 1; }
at=$(newest T handle/p/x)
xdotool mousemove --sync --window "$window" 300 150 mousedown 1 mousemove_relative 60 0 mousemove_relative 60 0
runs "$work/T"
xdotool mouseup 1
[ "$(newest T handle/p/x)" = "$at" ] || fail "the tool moves while it is stopped"

# --- the end: 20 s that were not stopped, and then the haptic thread has gone
xdotool key Return
fewer() { [ "$(threads)" -lt "$with" ]; }
until_seen fewer || fail "it does not rest after the end"
final=$(rows "$work/T")
debriefed() { # a dark card in the middle
  shot debrief
  [ "$(convert "$work/debrief.png" -crop 180x90+230+130 +repage -scale 1x1 -format '%[fx:r < 0.2 && g < 0.2]' info:)" = 1 ]
}
until_seen debriefed || fail "no card says what came of it"
# All of it is written by then, whatever becomes of the window.
for file in summary.json report.html frame.png; do until_seen [ -s "$work/T/$file" ] || fail "no $file while the card is shown"; done
# Looking back hides the card, and Space brings it again.
looks_back() { ! debriefed; }
xdotool key Left Left
until_seen looks_back || fail "the arrow keys do not look back"
# The expert's tool is beside it in lines of gold, at the first checkpoint, which nobody went to; F5 hides it.
gold() {
  shot back
  [ "$(convert "$work/back.png" -crop 110x60+215+165 +repage -fuzz 5% -fill black +opaque 'rgb(255,191,57)' -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
no_gold() { ! gold; }
until_seen gold || fail "the expert's tool is not beside it"
xdotool key F5
until_seen no_gold || fail "F5 does not hide the expert's tool"
xdotool key F5
until_seen gold || fail "F5 does not show it again"
xdotool key space
until_seen debriefed || fail "Space does not show what came of it"
xdotool key Prior
until_seen looks_back || fail "Page Up does not go to the event before"
[ "$final" -gt 41000 ] || fail "the pause was no time: $final ticks"

# --- R: another attempt, its tool where the first began
xdotool key r
until_seen more_rows "$work/T/attempt-2" 100 || fail "R does not start again"
[ "$(column "$work/T" tool/p/x | head -n 1)" = "$(column "$work/T/attempt-2" tool/p/x | head -n 1)" ] || fail "the second attempt begins elsewhere"

# --- out of sight it rests, as a pause does
stopped T/attempt-2 && fail "it rests before it is minimised"
xdotool windowminimize "$window"
until_seen stopped T/attempt-2 || fail "a minimised window pushes on"
xdotool windowactivate --sync "$window"

xdotool key --clearmodifiers alt+F4
wait_for_end
[ $code = 3 ] || fail "exit $code, not 3: $(cat "$work/said")"

# --- a drag of more than the screen's 800 pixels: on and on, the tool goes with it
open_window piping --size 640x360 --set time_limit=3600 --out "$work/D"
xdotool windowactivate --sync "$window"
until_seen more_rows "$work/D" 100 || fail "it does not run: $(cat "$work/said")"
xdotool mousemove --sync --window "$window" 300 150 mousedown 1
far() { awk -v a="$(column "$work/D" handle/p/x | head -n 1)" -v b="$(newest D handle/p/x)" 'BEGIN { exit !((b - a) ^ 2 > 2 ^ 2) }'; }
drag_on() { xdotool mousemove_relative 60 0 && far; }
until_seen drag_on || fail "the drag ended at the screen's edge: $(newest D handle/p/x)"
xdotool mouseup 1
xdotool key --clearmodifiers alt+F4
wait_for_end

# --- a scenario that is still to be baked: the window is there at once, says how far that is, and can be closed
export XDG_CACHE_HOME=$work/cold
open_window piping --size 640x360 --out "$work/B"
percent() { grep -qE 'Baking the .*: [0-9]+ %' "$work/said"; }
until_seen percent || fail "the bake does not say how far it is: $(cat "$work/said")"
card() { # the bar's colour somewhere in the middle of the window
  shot card
  [ "$(convert "$work/card.png" -crop 440x80+100+150 +repage -fuzz 8% -fill black +opaque 'rgb(84,164,255)' -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
until_seen card || fail "no card shows how far the bake is"
[ -z "${FULCRUM_PICTURES-}" ] || cp "$work"/*.png "$FULCRUM_PICTURES"
xdotool key --clearmodifiers alt+F4
wait_for_end
[ $code = 3 ] || fail "exit $code after it was closed while baking: $(cat "$work/said")"
grep -q 'before the scenario was ready' "$work/said" || fail "it does not say that nothing was run"
[ -e "$work/B" ] && fail "what was not run left results"
[ -z "$(find "$work/cold" -name '*.part' 2>/dev/null)" ] || fail "a half-baked file was left"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
