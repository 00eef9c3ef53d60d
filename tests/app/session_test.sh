#!/usr/bin/env bash
# A whole session under a display without a screen, by mouse and keys alone: the start page, a name, the tutorial, the
# teeth, what came of it, a look back, the report, and a second trial, which stands beside the first. Who trains is the
# pointer that sees only the window's pixels. $FULCRUM is the program, $PERSON the pointer. Where the pointer did not complete
# a scene and saw fewer pictures a second than it needs, the test is skipped: a busy machine decides nothing.
set -uo pipefail
support=$(dirname "$(readlink -f "$0")")/../support
. "$support/display.sh"
. "$support/start_page.sh"
. "$support/session.sh"
start_display 2560x1600
export XDG_DATA_HOME=$work/data XDG_CONFIG_HOME=$work/config

click() { xdotool mousemove --sync --window "$window" "$1" "$2" click 1; }
teeth=$(place teeth)

# --- the start page: a name
start_fulcrum
until_seen scenario_focused 0 || fail "the first scenario is not in focus"
for ((i = 0; i < ${#scenes[@]}; ++i)); do key Down; done
until_seen setting_focused 0 || fail "the arrows do not reach who trains"
key Return
xdotool type --window "$window" "Ana"
key Return
click 180 102
until_seen scenario_focused 0 || fail "a press does not choose the tutorial"
picture 1-start

# --- the tutorial
key Return
until_seen began tutorial || fail "the tutorial does not begin: $(cat "$work/said")"
practise tutorial
until_seen card_is_there || fail "no card says what came of the tutorial"
picture 2-tutorial
until_seen is_complete tutorial || fail "the tutorial is not complete"
key F10
until_seen scenario_focused 0 || fail "F10 does not go back to the start page"
until_seen trials Ana tutorial 1 || fail "the tutorial was not kept: $("$FULCRUM" results 2>&1)"

# --- the teeth, by the mouse
click 180 $((102 + 40 * teeth))
until_seen scenario_focused "$teeth" || fail "a press does not choose the teeth"
click 445 647 # Start
until_seen began teeth || fail "the teeth do not begin: $(cat "$work/said")"
first=$(newest teeth)
practise teeth
until_seen card_is_there || fail "no card says what came of the teeth"
picture 3-debrief
until_seen is_complete teeth || fail "the teeth are not complete"

until_seen trials Ana teeth 1 || fail "the trial is not kept before the window is left: $("$FULCRUM" results 2>&1)"

# --- the look back: a press on the time line, the event before, and what came of it again
click 640 690
until_seen no_card_is_there || fail "a press on the time line does not look back"
picture 4-looking-back
key Prior
key F5
picture 5-event
key space
until_seen card_is_there || fail "Space does not show what came of it"
until_seen [ -s "$first/report.html" ] || fail "there is no report"

# --- a second trial, which stands beside the first
key r
until_seen another teeth "$first" || fail "R does not start again"
practise teeth
until_seen card_is_there || fail "no card says what came of the second trial"
picture 6-progress
second=$(newest teeth)
until_seen is_complete teeth || fail "the second trial is not complete"
until_seen trials Ana teeth 2 || fail "the trials were not kept: $("$FULCRUM" results 2>&1)"
[ -s "$second/report.html" ] || fail "there is no second report"
[ -z "${FULCRUM_PICTURES-}" ] || cp "$second/report.html" "$FULCRUM_PICTURES/"
key F10
until_seen scenario_focused "$teeth" || fail "F10 does not go back from the teeth"
picture 7-start-again
key Escape
wait_for_end
[ "$code" = 0 ] || fail "it ended with $code: $(cat "$work/said")"

[ "$failures" = 0 ] || exit 1
echo "all good"
