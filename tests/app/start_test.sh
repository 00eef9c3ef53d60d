#!/usr/bin/env bash
# `fulcrum` without arguments, under a display without a screen: by keys alone a name is written, a scene is started and
# left again, and its trial is kept; by the mouse alone the same; what was chosen is remembered. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display
export XDG_DATA_HOME=$work/data XDG_CONFIG_HOME=$work/config

start_fulcrum() {
  "$FULCRUM" >"$work/said" 2>&1 &
  program=$!
  window=
  until_seen find_window
  [ -n "$window" ] || { cat "$work/said"; echo "FAILED: no window"; exit 1; }
  xdotool windowactivate --sync "$window"
}

# accent WxH+X+Y: what is in focus is surrounded there.
accent() {
  import -window "$window" "$work/part.png"
  [ "$(convert "$work/part.png" -crop "$1" +repage -fuzz 8% -fill black +opaque 'rgb(84,164,255)' -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
# focused ROW: of the column of scenarios, or of the settings.
scenario_focused() { accent "20x40+20+$((83 + 40 * $1))"; }
setting_focused() { accent "20x34+355+$((529 + 34 * $1))"; }
key() { xdotool key --window "$window" "$@"; }
# The newest run's folder, which is named after its scenario.
newest() { find "$work/data/fulcrum/runs" -maxdepth 1 -name "$1-*" 2>/dev/null | LC_ALL=C sort | tail -n 1; }
began() { [ -n "$(newest "$1")" ]; }
trials() { [ "$("$FULCRUM" results --participant "$1" 2>/dev/null | grep -c " $2 ")" = "$3" ]; }

mapfile -t scenes < <("$FULCRUM" list | awk '{ print $1 }')
place() { for i in "${!scenes[@]}"; do [ "${scenes[$i]}" != "$1" ] || echo "$i"; done; }
stick=$(place stick)

# --- by keys: to the scenario, to who trains, a name, and back to start it
start_fulcrum
until_seen scenario_focused 0 || fail "the first scenario is not in focus"
for ((i = 0; i < stick; ++i)); do key Down; done
until_seen scenario_focused "$stick" || fail "the arrows do not reach the stick"
for ((i = stick; i < ${#scenes[@]}; ++i)); do key Down; done
until_seen setting_focused 0 || fail "the arrows do not reach who trains"
key Return
xdotool type --window "$window" "Ana 3"
key Return
# Up to the scenario again: the last one is the nearest, and the stick before it.
for ((i = stick; i < ${#scenes[@]}; ++i)); do key Up; done
until_seen scenario_focused "$stick" || fail "the arrows do not lead back to the stick"
key Return
until_seen began stick || fail "nothing was started: $(cat "$work/said")"
runs "$(newest stick)" || fail "it does not run"
key F10
until_seen scenario_focused "$stick" || fail "F10 does not go back to the start page"
until_seen trials 'Ana 3' stick 1 || fail "the trial was not kept: $("$FULCRUM" results 2>&1)"

# --- by the mouse: another hand, then a press that chooses and a press that starts
click() { xdotool mousemove --sync --window "$window" "$1" "$2" click 1; }
click 490 $((547 + 34 * 0)) # the left arrow of who trains: nobody
click 705 $((547 + 34 * 1)) # the device's name: the next one, the expert
click 180 $((102 + 40 * stick))
until_seen scenario_focused "$stick" || fail "a press on a scenario does not choose it"
had=$(newest stick)
click 445 666 # Start
another() { [ "$(newest stick)" != "$had" ]; }
until_seen another || fail "the Start button does not start: $(cat "$work/said")"
runs "$(newest stick)" || fail "the expert does not move"
key F10
until_seen scenario_focused "$stick" || fail "F10 does not go back from what the expert shows"
trials 'Ana 3' stick 1 || fail "what the expert did was kept as somebody's"
click 580 666 # End
wait_for_end
[ "$code" = 0 ] || fail "it ended with $code: $(cat "$work/said")"

# --- a scenario that is still to be baked: Esc goes back to the start page, and nothing was run
sed -i 's/"scenario": "[a-z]*"/"scenario": "teeth"/' "$work/config/fulcrum/start.json"
teeth=$(place teeth)
kept_cache=${XDG_CACHE_HOME-}
export XDG_CACHE_HOME=$work/cold
start_fulcrum
until_seen scenario_focused "$teeth" || fail "the scenario that was chosen is not in focus"
key Return
baking() { # the bar's colour in the middle of the window
  import -window "$window" "$work/card.png"
  [ "$(convert "$work/card.png" -crop 500x20+390+375 +repage -fuzz 8% -fill black +opaque 'rgb(84,164,255)' -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
until_seen baking || fail "no card shows how far the bake is"
key Escape
until_seen scenario_focused "$teeth" || fail "Esc does not end the bake"
[ -z "$(newest teeth)" ] || fail "what was cancelled was run"
[ -z "$(find "$work/cold" -name '*.part' 2>/dev/null)" ] || fail "a half-baked file was left"
key Escape
wait_for_end
export XDG_CACHE_HOME=$kept_cache
sed -i 's/"scenario": "teeth"/"scenario": "stick"/' "$work/config/fulcrum/start.json"

# --- what was chosen is remembered, and Esc ends
grep -q '"scenario": "stick"' "$work/config/fulcrum/start.json" || fail "the scenario is not remembered"
start_fulcrum
until_seen scenario_focused "$stick" || fail "the scenario is not where it was"
key Escape
wait_for_end
[ "$code" = 0 ] || fail "Esc ended it with $code"

[ "$failures" = 0 ] || exit 1
echo "all good"
