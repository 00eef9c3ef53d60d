#!/usr/bin/env bash
# Files that a person or a scenario names: where they may lie, what they may be. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
content=$(dirname "$FULCRUM")/content
cp -r "$content/scenarios/sweep" own
mkdir own/devices
# With wide cells and spacings: it is baked again and again.
scenario() {
  sed "s/model: fingertip/model: $1/; s/^field:.*/field: {voxel: 0.004}/; s/^shell:.*/shell: {spacing: 0.006}/" \
    "$content/scenarios/sweep/scenario.yaml" >own/scenario.yaml
}
strong() { sed 's/^name:.*/name: Strong arm/; s/^max_force:.*/max_force: 20/' "$content/devices/fingertip.yaml"; }

# --- a device of the scenario's own is named as such, and replaces none that is installed
strong >own/devices/strong.yaml
scenario strong
expect 3 '"device": "scenario:strong"' "$FULCRUM" run ./own --headless --seconds 0.1 --json --out A
expect 0 'bit for bit' "$FULCRUM" replay A/tape --out B
grep -q '"device": "scenario:strong"' B/summary.json || fail "a replay does not say whose device it was"
expect 0 "On Strong arm, the scenario's own device" "$FULCRUM" explain ./own
expect 0 '"device": "scenario:strong"' "$FULCRUM" explain ./own --json
expect 3 '"device": "simulated"' "$FULCRUM" run ./own --headless --seconds 0.1 --device simulated:fingertip --json --out C
expect 0 'an installed device' "$FULCRUM" explain sweep
strong >own/devices/fingertip.yaml
scenario fingertip
expect 1 "'fingertip' is an installed device.*cannot change.*another name" "$FULCRUM" run ./own --headless --out X
rm own/devices/fingertip.yaml
mkdir -p pack/scenarios pack/devices
cp -r own pack/scenarios/
strong >pack/devices/fingertip.yaml # beside the scenario: nothing of its folder
expect 0 'On Fingertip on an arm, an installed device' "$FULCRUM" explain pack/scenarios/own

# --- nothing outside the folder
mkdir elsewhere
echo 'password: 1234' >elsewhere/secret.yaml
rm -r own/devices && ln -s ../elsewhere own/devices
scenario secret
expect 1 'leads out of the folder' "$FULCRUM" check ./own
"$FULCRUM" check ./own 2>&1 | grep -q password && fail "a file from elsewhere is quoted"
rm own/devices
scenario fingertip
head -c 100 /dev/zero >secret.bin
printf '{"asset":{"version":"2.0"},"buffers":[{"byteLength":100,"uri":"../secret.bin"}]}' >own/model.gltf
sed -i 's/finger.glb/model.gltf/' own/scenario.yaml
expect 1 'secret.bin, which cannot be read: it leads out of the folder' "$FULCRUM" check ./own
scenario fingertip

# --- files alone: a pipe would be waited for
mkfifo pipe own/pipe.yaml own/pipe.glb
wait_at_most() { timeout -s KILL 600 "$@"; }
expect 1 'it is a pipe, not a file' wait_at_most "$FULCRUM" run ./own --headless --device replay:pipe --out X
expect 1 'it is a pipe, not a file' wait_at_most "$FULCRUM" replay pipe
expect 1 'it is a pipe, not a file' wait_at_most "$FULCRUM" strip pipe
wait_at_most "$FULCRUM" replay pipe 2>&1 | grep -q 'did you mean' && fail "a pipe's own name is offered instead of it"
expect 1 'it is a device, not a file' wait_at_most "$FULCRUM" replay /dev/zero
sed -i 's/finger.glb/pipe.glb/' own/scenario.yaml
expect 1 'it is a pipe, not a file' wait_at_most "$FULCRUM" check ./own
scenario fingertip

# --- the cache says what is wrong with it, whatever the command
export XDG_CACHE_HOME=$work/cache
"$FULCRUM" run ./own --headless --seconds 0.1 --out D >/dev/null 2>&1
[ -z "$(find cache -name '*.part')" ] || fail "a bake leaves a part"
for file in cache/fulcrum/*; do echo damage >>"$file"; done
expect 3 'the cached bake .* was damaged' "$FULCRUM" run ./own --headless --seconds 0.1 --out E
"$FULCRUM" run ./own --headless --seconds 0.1 --out F 2>&1 | grep -q 'damaged' && fail "a repaired cache is called damaged"
rm -r cache && touch cache
for command in "run ./own --headless --seconds 0.1 --out G" "explain ./own" "replay E/tape --out H"; do
  # shellcheck disable=SC2086
  said=$("$FULCRUM" $command 2>&1)
  [ "$(grep -c 'could not be kept in' <<<"$said")" = 1 ] || fail "$command does not say once that nothing is kept: $said"
done
rm cache

# --- recorded motions: time steps that no scenario has, lines without end
header=timestamp,handle/p/x,handle/p/y,handle/p/z,handle/q/w,handle/q/x,handle/q/y,handle/q/z
motion() { printf '%s\n0,0,0,0,1,0,0,0\n%s,0,0,0,1,0,0,0\n' $header "$1" >motion.csv; }
motion 1e-300
expect 1 'recorded at another tick rate.*no scenario can have it, only 100 to 20000 Hz' "$FULCRUM" run ./own --headless --device replay:motion.csv --out X
motion 0.0003
expect 1 'give --set tick_rate_Hz=3333.33333333' "$FULCRUM" run ./own --headless --device replay:motion.csv --out X
rate=$("$FULCRUM" run ./own --headless --device replay:motion.csv --out X 2>&1 | sed -n 's/.*tick_rate_Hz=\(.*\)\.$/\1/p')
expect 3 'Not completed' "$FULCRUM" run ./own --headless --device replay:motion.csv --set tick_rate_Hz="$rate" --seconds 0.01 --out I
head -c 50000000 /dev/zero | tr '\0' ',' >commas.csv
# A sanitizer reserves more addresses than there are bytes: under one, and only there, the memory is not bounded.
bound="ulimit -v 2000000; "
[[ $(bash -c "$bound exec '$FULCRUM' --version" 2>&1) != *Sanitizer* ]] || bound=
for command in "strip commas.csv" "run ./own --headless --device replay:commas.csv --out X"; do
  expect 1 'line 1 is longer than 65536 bytes' bash -c "$bound exec '$FULCRUM' $command"
done
[ ! -e X ] || fail "a refused run left a folder"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
