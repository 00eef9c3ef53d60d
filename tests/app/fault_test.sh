#!/usr/bin/env bash
# What follows a fault that is injected: the force stays within the device's limits in every tick, is nothing two ticks
# after a stop and until it is acknowledged, and what was recorded is whole. One row of docs/faults.md after another.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
table=$(dirname "$(readlink -f "$0")")/../../docs/faults.md

# judge TRACE MAX_FORCE MAX_TORQUE: "STOP BITS STOPPED TICKS", or what is wrong. 1 kHz; a stop is a fault below 2^16.
judge() {
  awk -F, -v max_force="$2" -v max_torque="$3" '
    function norm(x, y, z) { return sqrt(x * x + y * y + z * z) }
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    {
      tick = NR - 2
      force = norm($at["device/force/x"], $at["device/force/y"], $at["device/force/z"])
      torque = norm($at["device/torque/x"], $at["device/torque/y"], $at["device/torque/z"])
      if (!(force <= max_force * (1 + 1e-9)) || !(torque <= max_torque * (1 + 1e-9))) { print "tick", tick, "commands", force, "N", torque, "N m"; exit }
      stopping = $at["fault"] % 65536
      if (stopping && !stopped) { since = tick; if (first == "") { first = tick; bits = stopping } }
      stopped = stopping
      if (stopped) ++stops
      if (stopped && tick >= since + 2 && (force > 0 || torque > 0)) { print "tick", tick, "commands", force, "N after the stop at", since; exit }
    }
    END { print first == "" ? "none" : first, bits + 0, stops + 0, NR - 1 }' "$1"
}

# Two scenes, on devices of six and of seven motors, one with a strip, one with pulses. Their limits as installed.
declare -A device=([stick]=freedom6s [plate]=w6d)
figure() { sed -n "s/^$2: *\([0-9.]*\).*/\1/p" "${FULCRUM_CONTENT-$(dirname "$FULCRUM")/content}/devices/${device[$1]}.yaml"; }
judged() { judge "$1/trace.csv" "$(figure "$2" max_force)" "$(figure "$2" max_torque)"; }

# fault NAME CODE STOP BITS STOPPED SCENE...: five seconds of the scene's trial with the fault at 1.2 s. STOP: the tick, or none.
fault() {
  local name=$1 code=$2 expected="$3 $4 $5" scene got said
  for scene in "${@:6}"; do
    rm -rf run again
    said=$("$FULCRUM" run "$scene" --headless --seconds 5 --fault "$name@1.2" --out run 2>&1)
    got=$?
    [ "$got" = "$code" ] || fail "$scene, $name: exit $got, not $code: $said"
    got=$(judged run "$scene")
    [ "${got% *}" = "$expected" ] || fail "$scene, $name: stop, bits and stopped ticks are '$got', not '$expected'"
    expect 0 "${got##* } ticks, the same as recorded, bit for bit" "$FULCRUM" replay run/tape --out again
    cmp -s run/trace.csv again/trace.csv || fail "$scene, $name: the replay's trace differs"
  done
}
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted
both=(stick plate)
fault unplug 4 1200 8 2000 "${both[@]}"
fault replug 3 1200 8 1000 stick
fault stall 3 1220 4 1000 stick
fault write-fail 3 1200 8 1000 stick
fault nan 3 1200 2 1000 "${both[@]}"
fault short-read 3 none 0 0 stick
fault frozen 3 none 0 0 stick
fault jump 3 none 0 0 "${both[@]}"
fault garbage 3 none 0 0 "${both[@]}"
fault late-reply 3 none 0 0 stick
fault sensor-drop 3 none 0 0 "${both[@]}"
expect 3 'connected, but its handle has not moved .*home or calibrate' "$FULCRUM" run stick --headless --seconds 5 --fault frozen@1.2 --out frozen

# Not acknowledged, a stop ends the run at once; two faults are one after the other.
expect 4 'stopped and not acknowledged|not a number' "$FULCRUM" run stick --headless --fault nan@1 --no-ack --out no_ack
[ "$(judged no_ack stick)" = "1000 2 1 1001" ] || fail "--no-ack: $(judged no_ack stick)"
expect 3 'nan at 1 s.*stall at 3 s' "$FULCRUM" run stick --headless --seconds 4 --fault nan@1 --fault stall@3 --out two
[ "$(judged two stick)" = "1000 2 2000 6000" ] || fail "two faults: $(judged two stick)"

# By the clock. A busy machine stops or delays such a run more often: what is asked is what the fault alone would do.
expect_each 2 'needs the clock: add --realtime' -- "$FULCRUM" run stick --headless --fault late@1
expect_each 3 'Late ticks: [1-9]' -- "$FULCRUM" run stick --headless --realtime --seconds 1.5 --fault late@0.6 --out late
expect 3 'lost: [1-9].*|haptic thread stood still' "$FULCRUM" run stick --headless --realtime --seconds 1.5 --fault pause@0.6 --out pause
for run in late pause; do
  got=$(judged $run stick)
  [[ $got =~ ^(none|[0-9]+)\ [0-9]+\ [0-9]+\ [0-9]+$ ]] || fail "$run: $got"
  expect 0 "${got##* } ticks, the same as recorded, bit for bit" "$FULCRUM" replay $run/tape --out "$run.again"
done
[[ $(judged pause stick) != none* ]] || fail "pause: the force was not stopped"

# The program's own: what is recorded up to there is kept, and the run goes on where it can.
expect 1 'Recording has stopped after the first 1[0-9]{3} ticks' "$FULCRUM" run stick --headless --seconds 3 --fault disk-full@1.2 --out full
grep -q '"ticks": 3000' full/summary.json || fail "disk-full: the run did not go on"
"$FULCRUM" run stick --headless --seconds 3 --fault kill@1.2 --out killed >/dev/null 2>&1
[ $? = 137 ] || fail "kill: the process lives"
for run in full killed; do
  rows=$(($(wc -l <$run/trace.csv) - 1))
  [ "$rows" -ge 950 ] && [ "$rows" -le 1200 ] || fail "$run: $rows ticks are left"
  expect_each 0 "tape ends early" "$rows ticks, the same as recorded, bit for bit" -- "$FULCRUM" replay $run/tape --out "$run.again"
done
unset VK_ICD_FILENAMES VK_DRIVER_FILES
expect 3 'there is no picture: .*VK_ERROR_DEVICE_LOST' "$FULCRUM" run stick --headless --seconds 1 --fault gpu-lost@0.5 --out lost
[ "$(wc -l <lost/trace.csv)" = 1001 ] || fail "gpu-lost: the run did not go on"

expect 2 "no fault 'unplugg'; there are unplug, replug" "$FULCRUM" run stick --headless --fault unplugg@1
expect 2 'does not say when: nan@T' "$FULCRUM" run stick --headless --fault nan
for name in unplug replug stall short-read garbage nan frozen jump late-reply write-fail sensor-drop late pause disk-full kill gpu-lost; do
  grep -q "^| \`$name\` " "$table" || fail "docs/faults.md has no row of $name"
done

[ "$failures" = 0 ] || { echo "$failures failures"; exit 1; }
echo "all good"
