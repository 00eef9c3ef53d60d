#!/usr/bin/env bash
# The commands around devices, from outside: fulcrum devices, --watch, device-test. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export XDG_DATA_HOME="$work/data"

# --- the list: what each can do stands in its table, and lines fit a terminal
expect_each 0 '^There$' '^Not there$' '^  polhem ' 'none is plugged in' -- "$FULCRUM" devices
in_one_line() { "$FULCRUM" devices | tr -s ' \n' ' '; }
expect_each 0 'senses 6 axes, 1000 times a second; pushes on 3 with 5 N; its firmware lets go after 0.5 s' 'with 12 N; no firmware watchdog is known' \
  'pushes nothing back; vibrates: left \(rumble\), right \(rumble\)' -- in_one_line
long=$("$FULCRUM" devices | awk 'length($0) > 100')
[ -z "$long" ] || fail "lines of over 100 letters: $long"
cp -r "$(dirname "$FULCRUM")/content/devices" tables && mkdir other && mv tables other/devices
sed -i 's/^max_force: 5 .*/max_force: 4.5/; s/^firmware_watchdog: .*//' other/devices/polhem.yaml
expect 0 'pushes on 3 with 4.5 N; no firmware watchdog' env FULCRUM_CONTENT="$work/other" "$FULCRUM" devices
"$FULCRUM" devices --json >devices.json || fail "devices --json: exit $?"
for key in name what present reason cure node permitted firmware capabilities axes_sensed max_force_N channels firmware_watchdog_s sample_rate_Hz; do
  grep -q "\"$key\"" devices.json || fail "devices --json has no $key"
done
grep -q '"firmware_watchdog_s": 0.5' devices.json || fail "devices --json: the watchdog of polhem is not its table's"

# --- watch: until Ctrl+C
"$FULCRUM" devices --watch >watched 2>said &
for ((i = 0; i < 600; ++i)); do
  grep -qs 'Ctrl+C' said && break
  sleep 0.1
done
grep -q 'Ctrl+C' said || fail "devices --watch says nothing"
kill -INT $!
wait $!
[ $? = 0 ] || fail "devices --watch ended by Ctrl+C with another code than 0"

# --- a test of a device, here of simulated ones
expect_each 0 '^samples +good +1000 new samples' '^push up and down +good' '^drop-outs +good' "lie in A\$" -- "$FULCRUM" device-test simulated:polhem --yes --out A
[ "$(head -1 A/device-test.csv)" = part,outcome,measure,value,unit ] || fail "device-test.csv has other columns"
step=$(sed -n 's/^encoder_step: *\([^ ]*\).*/\1/p' "$(dirname "$FULCRUM")/content/devices/polhem.yaml")
awk -F, -v step="$step" '/smallest step seen/ { n++; if ($(NF-1) < 999 * step || $(NF-1) > 1001 * step) bad = 1 } END { exit !(n == 3 && !bad) }' A/device-test.csv ||
  fail "the smallest steps of simulated:polhem are not the $step m of its table"
grep -q '</html>' A/device-test.html || fail "no device-test.html"
expect 1 'holds results.*--force' "$FULCRUM" device-test simulated:polhem --yes --out A
expect 0 '"outcome": "good"' "$FULCRUM" device-test simulated:polhem --yes --out A --force --json
expect_each 0 '^twist, tilting +good' '^push near and far +good' -- "$FULCRUM" device-test simulated:w6d --yes --out B
expect_each 0 '^push +unknown +It has no motors' '^vibration left +unknown' -- "$FULCRUM" device-test simulated:dualsense --yes
expect 1 'no terminal.*--yes' "$FULCRUM" device-test simulated:polhem </dev/null
expect 1 "'mouse' cannot be had: it needs a window" "$FULCRUM" device-test mouse --yes
expect 1 "'keyboard' cannot be had: it needs a window" "$FULCRUM" device-test keyboard --yes
expect 1 "'polhem' cannot be had: none is plugged in" "$FULCRUM" device-test polhem --yes
expect 1 "no device 'polhemm'; did you mean 'polhem'" "$FULCRUM" device-test simulated:polhemm --yes
expect 1 "There is no device 'nothing'" "$FULCRUM" device-test nothing --yes
expect 1 'Say which device is to be simulated' "$FULCRUM" device-test simulated --yes
expect 1 'no device that can be tested' "$FULCRUM" device-test replay:tape --yes
expect 2 'device' "$FULCRUM" device-test
# By the clock, on a device by its maker's library, for which the tests' own stands in. Its handle is held fast. Where the
# machine takes the processor away for 20 ms, the force is stopped, and that is said.
# Reports are folded to the terminal's width.
stopped() { tr -s ' \r\n' ' ' <"$1" | grep -q 'sent nothing for more than 20 ms'; }
real() { LD_LIBRARY_PATH=$STAND_INS "$FULCRUM" device-test omega6 --yes --out R >real 2>&1; }
expect 0 '^  omega6 ' env LD_LIBRARY_PATH="$STAND_INS" bash -c '"$FULCRUM" devices | sed "/^Not there/,\$d"'
real
case $? in
  0) grep -q '^push up and down *odd *The handle did not give way' real || fail "a held omega6: $(cat real)" ;;
  4) stopped real || fail "a stopped omega6 does not say why: $(cat real)" ;;
  *) fail "device-test omega6: $(cat real)" ;;
esac
[ -s R/device-test.html ] || fail "no report of omega6"
# The same at a terminal, where someone says no to all of it.
refuses() { while sleep 0.2; do echo n 2>/dev/null || return 0; done; }
refuses | LD_LIBRARY_PATH=$STAND_INS script -qec "'$FULCRUM' device-test omega6 --out T" /dev/null >asked 2>&1
for part in 'Let go of it.* Go on' 'Move it to the right' 'Press each of its buttons' 'push up, then down, with up to 1 N.* Go on' 'push up and down .*Left out'; do
  grep -qE "$part" asked || stopped asked || fail "at a terminal it says nothing like /$part/: $(cat asked)"
done
grep -q 'Did it go' asked && fail "it pushed where it was told not to"
[ -e data/fulcrum/reports ] || fail "without --out a report has no folder of its own"
[ "$(find data -name device-test.html | wc -l)" = 1 ] || fail "a test that was refused left a report"

# --- calibrate: what is kept is in the person's own configuration, and runs take it
export XDG_CONFIG_HOME="$work/config"
kept=$XDG_CONFIG_HOME/fulcrum/calibration/omega6.yaml
expect 1 'A simulated device is as its table has it' "$FULCRUM" calibrate simulated:polhem --yes
expect 1 "'polhem' cannot be had: none is plugged in" "$FULCRUM" calibrate polhem --yes
expect 1 "no terminal.*--yes" env LD_LIBRARY_PATH="$STAND_INS" "$FULCRUM" calibrate omega6 </dev/null
expect 1 "'mouse' cannot be had: it needs a window" "$FULCRUM" calibrate mouse --yes
expect 0 'There is no calibration of omega6' "$FULCRUM" calibrate omega6 --forget
# The stand-in's handle is held fast: it weighs nothing that can be told, and nothing is kept.
LD_LIBRARY_PATH=$STAND_INS "$FULCRUM" calibrate omega6 --yes >real 2>&1
case $? in
  3) tr -s ' \n' ' ' <real | grep -qE 'someone held it|it was held, lies on something' && grep -q 'Nothing was kept' real || fail "a held omega6 is weighed: $(cat real)" ;;
  4) stopped real || fail "a stopped omega6 does not say why: $(cat real)" ;;
  *) fail "calibrate omega6: $(cat real)" ;;
esac
[ ! -e "$kept" ] || fail "a calibration that found nothing left a file"
# At a terminal: who leaves out everything changes nothing; who says so holds it in the left hand.
refuses | LD_LIBRARY_PATH=$STAND_INS script -qec "'$FULCRUM' calibrate omega6" /dev/null >asked 2>&1
[ ! -e "$kept" ] || fail "who left out everything left a calibration: $(cat "$kept")"
answers() { # ANSWER...: each to the next question
  local question=0 answer
  for answer; do
    question=$((question + 1))
    until [ "$(grep -o 'Enter: ' asked | wc -l)" -ge $question ]; do sleep 0.1; [ ! -e ended ] || return; done
    sleep 0.2
    echo "$answer"
  done
  until [ -e ended ]; do sleep 0.1; done
}
rm -f asked && touch asked
answers n n l | { LD_LIBRARY_PATH=$STAND_INS script -qec "'$FULCRUM' calibrate omega6" /dev/null >asked 2>&1; touch ended; }
if ! stopped asked; then
  grep -q '^left_handed: true' "$kept" || fail "the left hand is not kept: $(cat asked)"
  expect 0 "calibrated, as $kept has it" "$FULCRUM" devices
fi
mkdir -p "${kept%/*}"
printf 'fulcrum: 1\ndevice: omega6\nhandle_weight: 0.25\nworkspace: {centre: [0.005, 0, 0], half_extents: [0.04, 0.04, 0.03]}\n' >"$kept"
expect 0 '"calibration": ".*/omega6.yaml"' "$FULCRUM" devices --json
# A run takes it, says so and keeps it on its tape; a simulated device of that name is as its table has it.
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted
held=(env LD_LIBRARY_PATH="$STAND_INS" "$FULCRUM" run stick --headless --realtime --seconds 0.3 --device omega6)
"${held[@]}" --out H >said 2>&1
grep -q "Device: calibrated, as $kept has it" said || fail "a run does not say that its device is calibrated: $(cat said)"
expect 0 'calibrated, as .*omega6.yaml has it' env LD_LIBRARY_PATH="$STAND_INS" "$FULCRUM" explain stick --device omega6
"$FULCRUM" run stick --headless --seconds 0.1 --device simulated:omega6 --out I 2>&1 | grep -q 'calibrated' && fail "a simulated device is calibrated"
mv "$kept" away
expect 0 'bit for bit' "$FULCRUM" replay H/tape --out H_again
mv away "$kept"
for damage in 's/0.25/99/' 's/omega6/touch/' 's/0.04,/1e-310,/' 's/handle_weight/handle_wait/' '1,$d'; do
  sed "$damage" "$kept" >damaged && cp damaged "$kept.new" && cp "$kept" whole && mv "$kept.new" "$kept"
  expect 1 'fulcrum calibrate omega6 --forget' env LD_LIBRARY_PATH="$STAND_INS" "$FULCRUM" explain stick --device omega6
  mv whole "$kept"
done
expect 1 'Neither XDG_CONFIG_HOME nor HOME' env -u XDG_CONFIG_HOME -u HOME LD_LIBRARY_PATH="$STAND_INS" "$FULCRUM" calibrate omega6 --yes
expect 0 'is removed' "$FULCRUM" calibrate omega6 --forget
[ ! -e "$kept" ] || fail "calibrate --forget leaves it"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
