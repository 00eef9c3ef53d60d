#!/usr/bin/env bash
# A window that is heard: OpenAL Soft plays into a file in place of a device. Muted it is silent, F4 brings the sound, the
# end tells what was heard, and without a device the run goes on. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display 640x480
export ALSOFT_DRIVERS=wave ALSOFT_CONF=$work/openal.conf
cat >"$ALSOFT_CONF" <<END
[general]
frequency = 48000
period_size = 256
periods = 4
channels = stereo
sample-type = int16
dither = false
[wave]
file = $work/played.wav
END
blows() { [ "$(rows "$work/$1")" = 0 ] && echo 0 || column "$work/$1" impact/count | awk '{ n += $1 } END { print n + 0 }'; }
more_blows() { [ "$(blows "$1")" -gt "$2" ]; }
# How many bytes of what was played so far are not those of silence. The header is shorter than what is left out.
sounding() { tail -c +101 "$work/played.wav" | tr -d '\000' | wc -c; }
loud() { [ "$(sounding)" -gt 1000 ]; }
# The hand may have done all by then, on a slow machine.
closes() {
  xdotool windowactivate --sync "$window" key --clearmodifiers alt+F4
  wait_for_end
  [ $code = 3 ] || [ $code = 0 ] || fail "exit $code: $(cat "$work/said")"
}

# The expert's hand knocks, again and again. It begins muted; F4 brings the sound.
open_window knock --device simulated --hand expert --mute --size 640x360 --out "$work/K"
until_seen more_rows "$work/K" 100 || fail "it does not run: $(cat "$work/said")"
xdotool windowactivate --sync "$window" key F4
until_seen loud || fail "F4 does not bring the sound: $(cat "$work/said")"
closes
grep -qE 'Heard: [0-9]+ blows? on .*: [0-9]+ ms from a blow to the loudspeaker, at most [0-9]+ ms' "$work/said" ||
  fail "it does not say what was heard: $(cat "$work/said")"
counted=$(sed -n 's/.*"blows": \([0-9]*\).*/\1/p' "$work/K/summary.json")
[ "${counted:-0}" -gt 0 ] && [ "$counted" -le "$(blows K)" ] || fail "'$counted' blows were heard, of $(blows K)"
grep -q '>Heard<' "$work/K/report.html" || fail "the report says nothing of what was heard"

# Muted to its end, it is silent, though blows are played.
open_window knock --device simulated --hand expert --mute --size 640x360 --out "$work/M"
until_seen more_blows M 1 || fail "nothing is struck: $(cat "$work/said")"
shot muted
[ -z "${FULCRUM_PICTURES-}" ] || cp "$work"/*.png "$FULCRUM_PICTURES"
closes
[ "$(stat -c %s "$work/played.wav")" -gt 100000 ] || fail "nothing is played"
[ "$(sounding)" = 0 ] || fail "a muted window is heard"
grep -q 'Heard: [1-9]' "$work/said" || fail "no blow was played: $(cat "$work/said")"

# No device: one sentence, and the run goes on.
unset ALSOFT_CONF
export ALSOFT_DRIVERS=alsa ALSA_CONFIG_PATH=/nothing
open_window knock --device simulated --hand expert --size 320x240 --out "$work/N"
until_seen more_blows N 0 || fail "it does not go on without a device: $(cat "$work/said")"
closes
[ "$(grep -c 'in silence: no sound device' "$work/said")" = 1 ] || fail "no sentence says why it is silent: $(cat "$work/said")"
grep -q 'ALSA lib\|AL lib' "$work/said" && fail "a library talks: $(cat "$work/said")"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
