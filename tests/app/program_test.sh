#!/usr/bin/env bash
# What scripts and people rely on: commands, exit codes, sentences, files. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# --- commands
expect 0 '^fulcrum [0-9]' "$FULCRUM" --version
expect 0 'run' "$FULCRUM" --help
for command in import list run replay results check explain devices device-test calibrate doctor stability compare ambiguity schema hardness uniformity workprecision strip; do expect 0 '.' "$FULCRUM" $command --help; done
expect 2 'run .*Run a scenario' env -u DISPLAY -u WAYLAND_DISPLAY "$FULCRUM" # app.start has it with a display
mkdir apart && cp "$FULCRUM" apart/fulcrum
expect 1 'apart/fulcrum-studies, which could not be started .*tools/run --build' apart/fulcrum hardness
expect 2 "hardnes'; did you mean 'hardness'" "$FULCRUM" hardnes
expect 2 "no subcommand 'rum'; did you mean 'run'" "$FULCRUM" rum piping
expect 2 "no subcommand 'bogus'; .*--help" "$FULCRUM" bogus
expect 2 "\`fulcrum run\` has no option '--hedless'; did you mean '--headless'" "$FULCRUM" run piping --hedless
expect 2 "has no option '--qq'; \`fulcrum check --help\` lists them" "$FULCRUM" check piping --qq=3
expect 2 '.' "$FULCRUM" run
expect 2 'no size' "$FULCRUM" run piping --size big
expect 2 "'0' has to be above 0" "$FULCRUM" run piping --headless --seconds 0
expect 2 'Could not convert: --seconds = abc' "$FULCRUM" run piping --headless --seconds abc
expect 2 '\-\-xr-space is where a headset shows the scene: add --xr' "$FULCRUM" run piping --headless --xr-space stage
expect 2 '\-\-xr-scale is how large' "$FULCRUM" run piping --headless --xr-scale 3
expect 2 '\-\-xr-space is where' "$FULCRUM" explain piping --xr-space stage
expect 2 'leave out --stereo' "$FULCRUM" explain piping --xr --stereo anaglyph
for length in --eye-distance=63 --convergence=500 --screen-height=300 --head=0,0,600; do
  expect 2 "^fulcrum: --xr has the headset's own eyes: leave out ${length%=*}" "$FULCRUM" run piping --xr "$length"
done
expect 2 '\-\-scene is of .workprecision picture' "$FULCRUM" workprecision --scene piping
for number in nan -nan inf 1e999; do
  expect 2 "'$number' is no finite number" "$FULCRUM" run piping --headless --stereo anaglyph --eye-distance "$number"
  expect 2 "'$number' is no finite number" "$FULCRUM" run piping --headless "--seconds=$number"
done
for number in 0 -1 -0 0.0; do expect 2 "^--seconds: '$number' has to be above 0$" "$FULCRUM" run piping --headless "--seconds=$number"; done
expect 2 "^--seed: '-1' has to be a whole number, 0 or above$" "$FULCRUM" run piping --headless --seed -1
expect 0 '^piping ' "$FULCRUM" list
expect 0 '"name": "piping"' "$FULCRUM" list --json
expect 0 'simulated' "$FULCRUM" devices
expect 0 'no display|there' env -u DISPLAY "$FULCRUM" devices
expect 0 'KERNEL=="hidraw\*".*uaccess' "$FULCRUM" devices --udev
expect_each 0 '^scheduling +(good|fair)' '^memory +(good|fair)' '^wake-ups +(good|fair) +Of 1000 ticks' '^processor +(good|fair)' '^usb +(good|fair)' \
  '^graphics +fair +Drawn in software, by llvmpipe' '^display +(good|bad)' '^devices +(fair|bad)' -- "$FULCRUM" doctor
expect 0 'display +bad .*--headless|no display' env -u DISPLAY -u WAYLAND_DISPLAY "$FULCRUM" doctor
expect 0 '"health": "fair"' "$FULCRUM" doctor --json
expect_each 0 'vibrotactile motion .*on left .rumble.*right .rumble' 'lateral force .*has no motors' -- "$FULCRUM" explain sweep --device dualsense
expect_each 0 'vibrotactile motion .* at 233 Hz on left .tone: a frequency.*right .tone' -- "$FULCRUM" explain sweep --device joycon
expect_each 0 'What this device leaves out' '^  force motors .* has none' '^It senses 6 axes.*; pushes nothing back' -- "$FULCRUM" explain sweep --device spacemouse
expect 0 '"by_device": true' "$FULCRUM" explain sweep --device spacemouse --json
expect_each 0 "On mouse" -- "$FULCRUM" explain sweep --device mouse
expect_each 0 "strip .*'mouse' has none" -- "$FULCRUM" explain stick --device mouse
for held in mouse+strip polhem+strip; do # the strip has a board of its own
  "$FULCRUM" explain stick --device $held >explained || fail "stick is not explained with $held"
  grep -q 'strip .* has none' explained && fail "$held has a strip, and explain says it has none"
done
expect 1 'no device' "$FULCRUM" explain sweep --device nothing
expect 0 'json-schema.org' "$FULCRUM" schema
expect 0 'llvmpipe' "$FULCRUM" run piping --gpu list
expect_each 0 field pointshell coupling integrator estimator surfaces shadow 'Left out' adaptive_window \
  'tool field' 'response *haptics .* constraint' 'friction .* contact.friction is 0' \
  "device's arms .* the scenario does not ask for it" 'circle of confusion .* asks for it' -- "$FULCRUM" explain piping
expect_each 0 'subsurface scattering +pipeline +the light that enters' 'textures +image .* 2 of them' -- "$FULCRUM" explain ear
expect 0 'detailed surfaces +pipeline +no material has more than one colour' "$FULCRUM" explain teeth
expect_each 0 '^  textures +image .* in all their sizes' 'subsurface scattering +pipeline no material' \
  'lights of models +buffer +no model brings one' 'stereo +pipeline +--stereo asks for it' -- "$FULCRUM" explain piping
for scenario in tutorial piping teeth ear plate knock stick sweep nut; do # each part says what it costs, or in which part that is
  free=$("$FULCRUM" explain "$scenario" --json 2>/dev/null | awk '
    /"left_out"/ { exit } /"name"/ { name = $0; none = 0 } /"kind": "haptics"/ { haptics = 1 } /"kind"/ && !/"haptics"/ { haptics = 0 }
    /"tick_us": null/ { none = 1 } /"counted_in": null/ && none && haptics { print name }')
  [ -z "$free" ] || fail "explain $scenario says no cost of $free"
done
expect_each 0 'workspace walls +haptics .*N/m and .*let go, the device holds' 'workspace drift +haptics .* us +by up to 5 %' -- \
  "$FULCRUM" explain piping --set device.workspace_walls.margin=0.01 --set device.drift=0.05
expect_each 0 "workspace walls .*has no motors" "workspace drift .*has no workspace to keep" -- \
  "$FULCRUM" explain piping --device keyboard --set device.workspace_walls.margin=0.01 --set device.drift=0.05
expect 1 'device.workspace_walls.stiffness is .* N/m, .*holds at most .*lower it' "$FULCRUM" run piping --headless --set device.workspace_walls.stiffness=90000
said=$("$FULCRUM" explain piping --set response=penalty 2>&1) || fail "explain with springs: exit $?"
grep -q 'no constraint solver is built' <<<"$said" || fail "springs: a constraint solver is built: $said"
grep -q 'tool field' <<<"$said" && fail "springs need no field of the tool"
expect 0 'edges .* contact.edges is 0' "$FULCRUM" explain piping --set contact.edges=0
expect_each 0 'features .*themselves' 'query .*contact.surface is triangles' 'edges .*contact.surface is triangles' -- \
  "$FULCRUM" explain tutorial --set contact.surface=triangles
expect 0 'features .* contact.surface is points' "$FULCRUM" explain tutorial
expect_each 0 'field .*nothing asks for impacts' 'pointshell .*nothing asks for impacts' -- "$FULCRUM" explain nut # though it has sound
expect 2 'vibrates at impacts' "$FULCRUM" run piping --headless --circle
expect 0 'good' "$FULCRUM" check piping
expect 0 '^\[\]$' "$FULCRUM" check piping --json

# --- runs; where the picture does not matter it is a small one, which is sooner drawn
small=(--size 160x90)
expect 0 'Completed' "$FULCRUM" run piping --headless --hand expert --out A
expect 0 'Completed' "$FULCRUM" run piping --headless --hand expert --out B "${small[@]}"
[ "$(sha256sum <A/trace.csv)" = "$(sha256sum <B/trace.csv)" ] || fail "two runs differ"
grep -q "$(sha256sum <A/trace.csv | cut -d' ' -f1)" A/summary.json || fail "summary.json has another trace_sha256"
expect 0 'bit for bit' "$FULCRUM" replay A/tape --out C
cmp -s A/trace.csv C/trace.csv || fail "the replay's trace differs"
cp -r "$(dirname "$FULCRUM")/content" other && sed -i 's/^max_force: 7.9 /max_force: 2.9 /' other/devices/phantom_like.yaml
expect 0 "the tape's file of the device 'phantom_like' is not the installed one" env FULCRUM_CONTENT="$work/other" "$FULCRUM" replay A/tape --out other/run
for file in summary.json trace.csv trace.json timing.csv tape frame.png; do [ -s "A/$file" ] || fail "no A/$file"; done
expect 1 'holds results.*--force' "$FULCRUM" run piping --headless --out A
expect 3 'Not completed' "$FULCRUM" run piping --headless --hand clumsy --seconds 1 --out D "${small[@]}"
expect 3 'Not completed' "$FULCRUM" run piping --headless --device simulated:w6d --seconds 0.5 --out on_w6d "${small[@]}"
head -1 on_w6d/trace.csv | grep -q 'actuator/load/twist' || fail "a scene on the W6D has no column of its seventh motor"
expect 0 'bit for bit' "$FULCRUM" replay on_w6d/tape --out on_w6d_again
expect 3 'Not completed' "$FULCRUM" run piping --headless --device replay:A/tape --seconds 1 --out E "${small[@]}"
expect 3 'Not completed' "$FULCRUM" run piping --headless --device replay:A/trace.csv --seconds 1 --out F "${small[@]}"
expect 3 'Late ticks: [0-9]+, lost: [0-9]+' "$FULCRUM" run piping --headless --realtime --seconds 2 --out G "${small[@]}"
for view in overview slot; do
  expect 3 'Not completed' "$FULCRUM" run piping --headless --seconds 0.1 --view $view --out V/$view --size 320x180
done
cmp -s V/overview/frame.png V/slot/frame.png && fail "--view slot draws the overview"
cmp -s V/overview/trace.csv V/slot/trace.csv || fail "--view changes the run"
expect 2 "no view 'slott'; did you mean 'slot'" "$FULCRUM" run piping --headless --view slott --out W
for mode in side-by-side top-bottom interlaced anaglyph; do
  expect 3 'Not completed' "$FULCRUM" run piping --headless --seconds 0.1 --view slot --stereo $mode --validate --out "S/$mode" --size 320x180
  cmp -s V/slot/trace.csv "S/$mode/trace.csv" || fail "--stereo $mode changes the run"
  grep -q '"second eye"' "S/$mode/summary.json" || fail "--stereo $mode: summary.json does not say what was built"
done
grep -q '"second eye"' V/slot/summary.json && fail "a second eye is built that nobody asked for"
[ "$(sha256sum S/*/frame.png V/slot/frame.png | cut -d' ' -f1 | sort -u | wc -l)" = 5 ] || fail "two modes have the same picture"
stereo=(run piping --headless --seconds 0.1 --size 320x180 --stereo)
expect 3 'Not completed' "$FULCRUM" "${stereo[@]}" interlaced --view slot --eye-distance 0 --out S/flat
expect 3 'Not completed' "$FULCRUM" "${stereo[@]}" anaglyph --screen-height 300 --head=-100,0,600 --convergence 300 --out S/window
expect 2 "no stereo mode 'anaglif'; did you mean 'anaglyph'" "$FULCRUM" "${stereo[@]}" anaglif
expect 2 "no stereo mode 'nonsense'; use side-by-side, top-bottom, interlaced, anaglyph" "$FULCRUM" "${stereo[@]}" nonsense
expect 2 "'1e9,0,600' is no place of a head: .*each within 100000" "$FULCRUM" "${stereo[@]}" anaglyph --screen-height 300 --head=1e9,0,600
expect 2 'head: give RIGHT,UP,BEFORE in mm' "$FULCRUM" "${stereo[@]}" anaglyph --screen-height 300 --head=1,2,-3
expect 2 'add --screen-height' "$FULCRUM" "${stereo[@]}" anaglyph --head=0,0,500
expect 2 '--convergence is of pictures for two eyes: add --stereo' "$FULCRUM" run piping --headless --convergence 400
expect 0 'stereo .*--stereo asks for it' "$FULCRUM" explain piping
expect 0 'second eye .*640 x 720' "$FULCRUM" explain piping --stereo side-by-side
[ -e W ] && fail "a run with an unknown view left a folder"
expect 2 "no view 'slott'" env XDG_CACHE_HOME="$work/cold" "$FULCRUM" run piping --view slott --out W
expect 1 'no hand' env XDG_CACHE_HOME="$work/cold" "$FULCRUM" run piping --headless --hand nobody --out W
[ -e cold ] && fail "an unknown view or hand was refused after a bake"
expect 3 '"seed": 7' "$FULCRUM" run piping --headless --seconds 0.1 --seed 7 --json --out H "${small[@]}"
expect 3 '"seed": 7' "$FULCRUM" run piping --headless --seconds 0.1 --seed 7 --set time_limit=60 --json --out H --force "${small[@]}"

# --- reports: of one device, since the study takes ten seconds of a processor for each
expect 1 "no device 'phantom_lik'; did you mean 'phantom_like'" "$FULCRUM" stability --device phantom_lik --out S
expect 0 'stiffest walls' "$FULCRUM" stability --device phantom_like --out S
[ "$(head -1 S/stability.csv)" = device,delay_ticks,B,K_simulated,K_exact,K_passive ] || fail "stability.csv has other columns"
grep -q '^phantom_like,2,' S/stability.csv || fail "stability.csv knows no phantom_like"
grep -q '^polhem,' S/stability.csv && fail "stability --device phantom_like studies others, too"
grep -q '</html>' S/stability.html || fail "no stability.html"
expect 1 'holds results.*--force' "$FULCRUM" stability --out S
rm S/stability.csv # half of a report is one, too
expect 1 'stability.html.*--force' "$FULCRUM" stability --out S

# --- bad input
expect 1 'no hand' "$FULCRUM" run piping --headless --hand nobody --out X
expect 1 'no device' "$FULCRUM" run piping --headless --device nothing --out X
expect 1 'nothing.yaml|nothing' "$FULCRUM" run piping --headless --device simulated:nothing --out X
expect 1 "'mouse' cannot be had: it needs a window" "$FULCRUM" run piping --headless --device mouse --out X
expect 1 "'keyboard' cannot be had: it needs a window" "$FULCRUM" run piping --headless --device keyboard --out X
expect 1 "'spacemouse' cannot be had: none is plugged in" "$FULCRUM" run piping --headless --realtime --device spacemouse --out X
expect 1 "'spacemouse' cannot be had" "$FULCRUM" run piping --device spacemouse+dualsense --headless --realtime --out X
expect 1 "Nothing vibrates by 'mouse'" "$FULCRUM" run piping --headless --device spacemouse+mouse --out X
expect 1 "'strip' moves nothing: .*polhem.strip" "$FULCRUM" run stick --headless --device strip --out X
expect 1 "'joycon' cannot be had: the left one is not paired" "$FULCRUM" run piping --headless --realtime --device joycon --out X
expect 1 'display' env -u DISPLAY -u WAYLAND_DISPLAY "$FULCRUM" run piping --out X
expect 1 'pip' "$FULCRUM" run pipin --headless
expect 1 'stiffness' "$FULCRUM" run piping --headless --set contact.stifness=1
expect 1 '.' "$FULCRUM" run piping --headless --set contact.stiffness=-1
expect 1 '.' "$FULCRUM" replay nothing.tape
expect 1 '.' "$FULCRUM" replay A/trace.csv
head -c 100000 A/tape >short.tape
expect 0 'ends early' "$FULCRUM" replay short.tape --out I
content=$(dirname "$FULCRUM")/content/scenarios/piping
cp -r "$content" bad
edit() { cp "$content/scenario.yaml" bad/ && sed -i "$1" bad/scenario.yaml; }
edit 's/^time_limit:.*/time_limt: 90/' && expect 1 'scenario.yaml:[0-9]+:1: .*time_limit' "$FULCRUM" check bad/scenario.yaml
edit 's/^seed:.*/seed: many/' && expect 1 'scenario.yaml:[0-9]+:[0-9]+: ' "$FULCRUM" check bad/scenario.yaml
edit 's#piping.glb#../../../piping.glb#' && expect 1 'folder' "$FULCRUM" check bad/scenario.yaml
edit 's#piping.glb#missing.glb#' && expect 1 'missing.glb' "$FULCRUM" check bad/scenario.yaml
edit 's/^seed:.*/&/' && head -c 50000 "$content/piping.glb" >bad/piping.glb && expect 1 'truncated|damaged' "$FULCRUM" check bad/scenario.yaml

edit 's/^torque_substitution:.*/torque_substitution: {bad_above: 0.1, ghost: {below: 0.5}}/' && expect 1 "'below' that is smaller than 'above'" "$FULCRUM" check bad/scenario.yaml

# --- no Vulkan: the run counts, the picture is missing and said to be
expect 3 'no picture' env VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing "$FULCRUM" run piping --headless --seconds 0.2 --out J
[ -s J/trace.csv ] && [ ! -e J/frame.png ] || fail "without Vulkan: a trace and no picture were to be there"

# --- a full disk: said, and what was written stays
expect 1 'Cannot write K/trace.csv.*--out' bash -c "ulimit -f 2000; exec '$FULCRUM' run piping --headless --hand expert --out K ${small[*]}"
[ "$(wc -l <K/trace.csv)" -gt 100 ] || fail "a full disk lost the trace"

# --- SIGKILL: all but the last second is kept
"$FULCRUM" run piping --headless --hand expert --realtime --out L >/dev/null 2>&1 &
for ((i = 0; i < 1200; ++i)); do # until there is more than a second of it, however slow the machine
  [ -f L/trace.csv ] && [ "$(wc -l <L/trace.csv)" -gt 2000 ] && break
  sleep 0.1
done
kill -9 $!
wait $! 2>/dev/null
rows=$(wc -l <L/trace.csv)
[ "$rows" -gt 1000 ] || fail "SIGKILL after some seconds left $rows rows"
expect 0 'ends early' "$FULCRUM" replay L/tape --out M

# --- no colour where it is not wanted
"$FULCRUM" list | grep -q $'\033' && fail "colour without a terminal"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
