#!/usr/bin/env bash
# A display that does not answer for 7 s, where 5 s are what it may: the force is off from then on, which is said, and stays
# off until the trainee goes on. A simulated hand has nobody who could, and is not stopped. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display
unanswered=64

jam() {
  kill -STOP $xvfb
  sleep 7
  kill -CONT $xvfb
}
# of the newest tick: whether the force is stopped for that; whether it is not stopped at all
jammed() { column "$work/$1" fault | tail -1 | awk -v bit=$unanswered '{ exit !(int($1 / bit) % 2) }'; }
goes_on() { column "$work/$1" fault | tail -1 | awk '{ exit $1 % 65536 != 0 }'; }

# What is pressed while the display does not answer: by a program that is connected before, and whose keys the server has when it
# goes on.
press_meanwhile() { # KEY
  xdotool sleep 3 key "$1" &
  sleep 1
}

open_window piping --device mouse --mute --size 320x180 --set time_limit=3600 --out "$work/A"
xdotool windowactivate --sync "$window"
runs "$work/A" || fail "it does not run"
press_meanwhile Return
press_meanwhile r
jam
until_seen jammed A || fail "the force stays on while the display does not answer: $(column "$work/A" fault | sort | uniq -c)"
until_seen grep -q '^fulcrum: the display did not answer in time: the force is off' "$work/said" || fail "nothing is said of it: $(cat "$work/said")"
runs "$work/A"
jammed A || fail "the force is back by itself"
[ ! -e "$work/A/attempt-2" ] || fail "what was pressed meanwhile begins another attempt"
xdotool key --window "$window" Return
until_seen goes_on A || fail "Enter does not go on: $(column "$work/A" fault | tail -1)"
[ "$(grep -c 'did not answer in time' "$work/said")" = 1 ] || fail "it is said more than once: $(cat "$work/said")"
xdotool key --clearmodifiers --window "$window" alt+F4
wait_for_end
tr -d ' \n' <"$work/A/summary.json" | grep -q '"faults":\[[^]]*"unanswered"' || fail "the summary does not tell of it: $(grep -A 5 '"faults"' "$work/A/summary.json")"

open_window piping --device simulated --mute --size 320x180 --set dwell=600 --set time_limit=3600 --out "$work/B"
runs "$work/B" || fail "it does not run"
jam
runs "$work/B" || fail "it does not go on"
column "$work/B" fault | awk -v bit=$unanswered 'int($1 / bit) % 2 { n = 1 } END { exit n }' || fail "a simulated hand is stopped"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
