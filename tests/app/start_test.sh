#!/usr/bin/env bash
# `fulcrum` without arguments, under a display without a screen: by keys alone a name is written, a scene is started and
# left again, and its trial is kept; by the mouse alone the same; settings change what is seen; what was
# chosen is remembered; a bake can be cancelled. $FULCRUM is the program.
set -uo pipefail
support=$(dirname "$(readlink -f "$0")")/../support
. "$support/display.sh"
. "$support/start_page.sh"
start_display
export XDG_DATA_HOME=$work/data XDG_CONFIG_HOME=$work/config

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
click 490 $((535 + 34 * 0)) # the left arrow of who trains: nobody
click 490 $((535 + 34 * 1)) # the left arrow of the device: the expert, which is the last one
click 180 $((102 + 40 * stick))
until_seen scenario_focused "$stick" || fail "a press on a scenario does not choose it"
had=$(newest stick)
click 445 647 # Start
until_seen another stick "$had" || fail "the Start button does not start: $(cat "$work/said")"
runs "$(newest stick)" || fail "the expert does not move"
key F10
until_seen scenario_focused "$stick" || fail "F10 does not go back from what the expert shows"
trials 'Ana 3' stick 1 || fail "what the expert did was kept as somebody's"
click 705 647 # End
wait_for_end
[ "$code" = 0 ] || fail "it ended with $code: $(cat "$work/said")"

# --- what was chosen is remembered, and Esc ends
grep -q '"scenario": "stick"' "$work/config/fulcrum/start.json" || fail "the scenario is not remembered"
start_fulcrum
until_seen scenario_focused "$stick" || fail "the scenario is not where it was"

# --- what takes long can be cancelled: with nothing in the cache, piping's models have to be baked
key Escape
wait_for_end
piping=$(place piping)
XDG_CACHE_HOME=$work/empty start_fulcrum
until_seen scenario_focused "$stick" || fail "the scenario is not where it was"
for ((i = stick; i > piping; --i)); do key Up; done
until_seen scenario_focused "$piping" || fail "the arrows do not reach piping"
key Return
bakes() { accent 10x6+390+377; } # the bar of its progress
until_seen bakes || fail "no progress is shown: $(cat "$work/said")"
picture bakes
key Escape
until_seen scenario_focused "$piping" || fail "Esc does not lead back from a bake: $(cat "$work/said")"
began piping && fail "what was cancelled was started"
key Escape
wait_for_end
[ "$code" = 0 ] || fail "after a cancelled bake it ended with $code: $(cat "$work/said")"
start_fulcrum
until_seen scenario_focused "$piping" || fail "the scenario is not where it was"
for ((i = piping; i < stick; ++i)); do key Down; done
until_seen scenario_focused "$stick" || fail "the arrows do not lead back to the stick"

# --- settings: by the mouse larger text and back, by keys other colours, and all of it is remembered
settings=$work/config/fulcrum/settings.json
set_to() { grep -q "\"$1\": $2" "$settings" 2>/dev/null; }
click 590 647 # Settings
until_seen accent 20x40+372+257 || fail "the settings do not open: $(cat "$work/said")"
click 888 279 # the right arrow of the text's size
until_seen set_to text_size 1.25 || fail "larger text is not remembered: $(cat "$settings")"
until_seen accent 25x45+305+233 || fail "the text does not become larger"
click 480 259 # its left arrow, where that is now
until_seen set_to text_size 1.0 || fail "smaller text is not remembered: $(cat "$settings")"
key Down
key Right
until_seen set_to palette '"colour_blind"' || fail "other colours are not remembered: $(cat "$settings")"
# From the panel to its button, from there to the scenarios, and from there to the end.
esc_ends() { gone || { key Escape; sleep 0.5; gone; }; }
until_seen esc_ends || fail "Esc does not end it"
blue=64,150,255
wait_for_end
[ "$code" = 0 ] || fail "Esc ended it with $code"
start_fulcrum
until_seen scenario_focused "$stick" || fail "the colours are not as they were"
key Escape
wait_for_end

[ "$failures" = 0 ] || exit 1
echo "all good"
