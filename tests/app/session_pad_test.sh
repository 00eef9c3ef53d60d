#!/usr/bin/env bash
# A session by a gamepad alone, an Xbox pad that umockdev stands in for: from the start page the stick, done by sticks and
# triggers, what came of it, a look back, a second trial, and the way back to the start page. Who trains sees only the window's pixels.
# $FULCRUM is the program, $PAD plays the pad, $PERSON holds it. On a machine too slow for a person it is skipped.
set -uo pipefail
support=$(dirname "$(readlink -f "$0")")/../support
. "$support/display.sh"
start_display
export XDG_DATA_HOME=$work/data XDG_CONFIG_HOME=$work/config
. "$support/start_page.sh"
unhurried stick
. "$support/pad.sh"
. "$support/session.sh"

start_fulcrum "$PAD" "$pad"
stick=$(place stick)
until_seen scenario_focused 0 || fail "the first scenario is not in focus"
for ((i = 0; i < stick; ++i)); do tap down; done
until_seen scenario_focused "$stick" || fail "the cross does not reach the stick"
# To the device, which is the gamepad after the mouse.
for ((i = stick; i < ${#scenes[@]} + 1; ++i)); do tap down; done
until_seen setting_focused 1 || fail "the cross does not reach the device"
on_pad() { grep -q '"device": "gamepad"' "$work/config/fulcrum/start.json" 2>/dev/null; }
tap b
for ((i = stick; i < ${#scenes[@]} - 1; ++i)); do tap up; done
until_seen scenario_focused "$stick" || fail "B does not lead back to the scenarios"
picture pad-1-start
tap a
until_seen began stick || fail "nothing was started: $(cat "$work/said")"
on_pad || fail "the pad is not the device that is taken"
first=$(newest stick)
practise stick "$pad"
until_seen card_is_there || fail "no card says what came of it"
picture pad-2-debrief
until_seen is_complete stick || fail "the stick is not complete"

# --- the look back: by the cross, by bumpers from event to event, and what came of it again
tap left left
until_seen no_card_is_there || fail "the cross does not look back"
picture pad-3-looking-back
tap left_bumper
picture pad-4-event
tap a
until_seen card_is_there || fail "A does not show what came of it"

# --- once more
tap y
until_seen another stick "$first" || fail "Y does not start again"
practise stick "$pad"
until_seen card_is_there || fail "no card says what came of the second trial"
picture pad-5-again
until_seen is_complete stick || fail "the second trial is not complete"
tap back
until_seen scenario_focused "$stick" || fail "Back does not go to the start page"
tap b
wait_for_end
[ "$code" = 0 ] || fail "it ended with $code: $(cat "$work/said")"

[ "$failures" = 0 ] || exit 1
echo "all good"
