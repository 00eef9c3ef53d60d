#!/usr/bin/env bash
# A scene that is heard, from outside: sound.wav of a run without a window, that nothing of the run depends on it, and
# what is said where it cannot be had. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted
column() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } { print $c }' "$1/trace.csv"; }
run=("$FULCRUM" run knock --headless --hand expert --seconds 16)

# --- the same run, heard and not, and of a scenario that does not name it: the same ticks
mkdir silent
cp -r "$FULCRUM_CONTENT/scenarios/knock/." silent
sed -i '/^sound:/d' silent/scenario.yaml
expect 3 'Not completed' "${run[@]}" --wav --out A
expect 3 'Not completed' "${run[@]}" --out B
expect 3 'Not completed' "$FULCRUM" run silent/scenario.yaml --headless --hand expert --seconds 16 --out C
cmp A/trace.csv B/trace.csv || fail "what is heard changes the trace"
cmp A/trace.csv C/trace.csv || fail "the key 'sound' changes the trace"
grep -q '"scene sound"' A/summary.json || fail "the summary does not list the sound"
[ -e B/sound.wav ] && fail "sound.wav without --wav"

# --- the file: stereo, 48 kHz, 16 bit, 16 s and 1.5 s in which it rings on
header=$(od -An -t u2 -j 20 -N 16 A/sound.wav | tr -s ' \n' ' ')
[ "$header" = " 1 2 48000 0 60928 2 4 16 " ] || fail "another header: $header"
[ "$(stat -c %s A/sound.wav)" = $((44 + 4 * 48000 * 35 / 2)) ] || fail "another length: $(stat -c %s A/sound.wav) bytes"

# --- silence until a checkpoint is reached or something is struck
first=$(paste <(column A task/step) <(column A impact/count) | awk '$1 > 0 || $2 > 0 { print NR - 1; exit }')
samples() { od -An -v -t d2 -w4 -j 44 "$1/sound.wav"; }
samples A | head -n $((48 * first)) | grep -qv '^ *0 *0$' && fail "a sound before anything happened"

# --- after the last blow, of steel, the tone by which it shakes the hand, four octaves up; and the same on a device that
# shakes nothing, where no impacts are detected
last=$(column A impact/count | awk '$1 > 0 { last = NR - 1 } END { print last }')
felt=$(column A impact_vibration/frequency_Hz | sed -n "$((last + 1))p")
like_felt() { # FOLDER PART: how far off it may be
  samples "$1" | awk -v last=$((48 * last)) -v felt="$felt" -v part="$2" '
    NR > last + 480 && NR <= last + 480 + 9600 { # 200 ms, from 10 ms after it on
      if (before < 0 && $1 >= 0) { end = NR; if (!crossings++) begin = NR }
      before = $1
      if ($1 > 100) loud = 1
    }
    END {
      heard = end > begin ? (crossings - 1) * 48000 / (end - begin) : 0
      if (!loud) print "the last blow is not heard"
      if (heard < (1 - part) * 16 * felt || heard > (1 + part) * 16 * felt) print heard " Hz are heard, and " felt " Hz felt"
    }' >wrong
  [ -s wrong ] && fail "$1: $(cat wrong)"
}
[ "${last:-0}" -gt 0 ] || fail "nothing was struck"
like_felt A 0.02
expect 3 'Not completed' "$FULCRUM" run knock --headless --device replay:A/trace.csv --set device.model=two_channel --seconds 16 --wav --out R
head -n 1 R/trace.csv | grep -q impact && fail "impacts are detected for a device that cannot push"
like_felt R 0.05

# --- muted, it is silent
expect 3 'Not completed' "${run[@]}" --wav --mute --out D
[ "$(od -An -v -t d2 -j 44 D/sound.wav | tr -d ' \n' | tr -d 0)" = "" ] || fail "a muted run is heard"

# --- what is built
expect 0 'scene sound +sound +blows as wood 432 Hz, steel 640 Hz, rubber 288 Hz; sliding; chimes' "$FULCRUM" explain knock
expect 0 'scene sound +sound +the scenario does not name it' "$FULCRUM" explain silent/scenario.yaml
expect 0 'scene sound' "$FULCRUM" explain knock --set sound.slide=0

# --- what cannot be had
expect_each 1 "'sound.gain' must be at least 0 and at most 1" -- "$FULCRUM" run knock --headless --out X --set sound.gain=2
expect_each 1 'sound' 'pitch' -- "$FULCRUM" run knock --headless --out X --set sound.pich=3
expect_each 1 'materials/steal.yaml' 'steel' -- "$FULCRUM" run knock --headless --out X --set sound.material=steal
expect 2 '--wav .*add --headless' "$FULCRUM" run knock --wav
expect 1 "does not name 'sound'" "$FULCRUM" run silent/scenario.yaml --headless --wav --seconds 1 --out E

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
