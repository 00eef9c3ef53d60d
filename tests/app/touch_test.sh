#!/usr/bin/env bash
# Vibrators at the finger, from outside: devices that have them, what explain says, the WAV files. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted

# --- a device that cannot push vibrates in its place; one that can is as it was without
expect 3 'Not completed' "$FULCRUM" run piping --headless --hand clumsy --seconds 5 --device simulated:two_channel --out A
for name in left right; do
  [ "$(stat -c %s A/vibrotactile_motion-$name.wav)" = $((44 + 2 * 48000 * 5)) ] || fail "A/vibrotactile_motion-$name.wav is not 5 s of samples"
done
cmp -s A/vibrotactile_motion-left.wav A/vibrotactile_motion-right.wav && fail "both channels got the same"
[ "$(tail -c +45 A/vibrotactile_motion-left.wav | tr -d '\0' | wc -c)" -gt 1000 ] || fail "nothing vibrated"
header=$(head -1 A/trace.csv)
for column in gain level/left level/right shortfall glide x direction force; do
  [[ ",$header," == *",vibrotactile_motion/$column,"* ]] || fail "the trace has no vibrotactile_motion/$column"
done
expect 0 'bit for bit' "$FULCRUM" replay A/tape --out B
for file in vibrotactile_motion-left.wav vibrotactile_motion-right.wav trace.csv; do cmp -s A/$file B/$file || fail "the replay's $file differs"; done
expect 3 'Not completed' "$FULCRUM" run piping --headless --hand clumsy --seconds 1 --out C
head -1 C/trace.csv | grep -q vibrotactile_motion/ && fail "a device that pushes has columns of its vibrators"
ls C | grep -q wav && fail "a device without vibrators left a WAV"

# --- rumble motors get an amplitude a tick
expect 3 'Not completed' "$FULCRUM" run piping --headless --hand clumsy --seconds 5 --device simulated:rumble_pad --out D
[ "$(stat -c %s D/vibrotactile_motion-left.wav)" = $((44 + 2 * 1000 * 5)) ] || fail "D/vibrotactile_motion-left.wav is not a sample a tick"

# --- WAVs are results: they are not overwritten, and --force replaces them, whatever their channels are called
mkdir E && touch E/vibrotactile_motion-thumb.wav E/touch-thumb.wav # the second as earlier versions named it
expect 1 'holds results .*vibrotactile_motion-thumb.wav' "$FULCRUM" run piping --headless --seconds 0.1 --out E
expect 3 'Not completed' "$FULCRUM" run piping --headless --seconds 0.1 --out E --force
[ -e E/vibrotactile_motion-thumb.wav ] || [ -e E/touch-thumb.wav ] && fail "--force left a WAV of another run"

# --- every scene runs on it; explain says what it is and what is left out
for scene in piping teeth ear plate knock nut; do
  expect 3 'Not completed' "$FULCRUM" run $scene --headless --seconds 0.3 --device simulated:two_channel --out "on/$scene"
  expect 3 'Not completed' "$FULCRUM" run $scene --headless --seconds 0.3 --device simulated:rumble_pad --out "pad/$scene"
done
expect 0 'vibrotactile motion .*logarithmic.*233 Hz on left .48 kHz.*in place of the force' "$FULCRUM" explain piping --set device.model=two_channel
expect 0 "vibrotactile motion .*'Phantom-like arm' has no channels" "$FULCRUM" explain piping
expect 0 'vibrotactile motion .*it is a fallback, and .*has motors' "$FULCRUM" explain piping --set device.model=fingertip
expect 0 'vibrotactile motion .*does not name it' "$FULCRUM" explain knock

# --- as a sweep, with a force and without
sweep='vibrotactile_motion={as: sweep, lateral_force: 2, onset: asynchronous}'
expect 0 'one after the other.*with 2 N' "$FULCRUM" explain piping --set device.model=fingertip --set "$sweep"
expect 0 'vibration of the sweep .*has no channels' "$FULCRUM" explain piping --set "$sweep"
expect 1 'carrier_Hz' "$FULCRUM" explain piping --set vibrotactile_motion.carrier_Hz=2000

# --- a full disk: said, and the run goes on
run="run knock --headless --hand clumsy --seconds 8 --device simulated:two_channel --set tick_rate_Hz=100"
for said in 'Cannot write F/vibrotactile_motion-.*--out' 'Not completed after 8.0 s'; do
  expect 1 "$said" bash -c "ulimit -f 400; exec '$FULCRUM' $run --set 'vibrotactile_motion={as: fallback}' --out F --force"
done

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
