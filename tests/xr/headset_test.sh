#!/usr/bin/env bash
# Scenes in a headset, on the runtime of the tests' own (tests/xr/runtime/script.h), under Debian's validation layer of
# OpenXR where it is installed. $FULCRUM is the program, $RUNTIME the manifest. What is waited for is seen, never timed.
#   headset_test.sh WHAT, one of the functions below
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
. "$(dirname "$(readlink -f "$0")")/../support/hand_to_pixel.sh"
work=$(mktemp -d)
program=
trap '[ -z "$program" ] || kill -9 $program 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1
limit=${FULCRUM_TEST_LIMIT:-300} # s, ends what hangs, and decides nothing else
export XR_RUNTIME_JSON=$RUNTIME FULCRUM_XR_SCRIPT=$work/script FULCRUM_XR_LOG=$work/log XDG_CONFIG_HOME=$work/config
unset DISPLAY WAYLAND_DISPLAY
mkdir -p config/fulcrum && echo '{"picture": "lowest"}' >config/fulcrum/settings.json

layer=/usr/share/openxr/1/api_layers/explicit.d/XrApiLayer_core_validation.*.json
# shellcheck disable=SC2086
if ls $layer >/dev/null 2>&1; then
  export XR_ENABLE_API_LAYERS=XR_APILAYER_LUNARG_core_validation XR_CORE_VALIDATION_EXPORT_TYPE=text \
    XR_CORE_VALIDATION_FILE_NAME=$work/messages
else
  echo "openxr-layer-corevalidation is not installed: calls are judged by the tests' runtime alone"
fi

# goes_well: neither the runtime nor the layers had anything to say of what was just run, and its end was in order.
goes_well() {
  ! grep -m 5 '^WRONG' log || fail "$1: the runtime was called wrongly"
  [ ! -s messages ] || fail "$1: the validation layer says: $(head -5 messages)"
  [ -z "${XR_ENABLE_API_LAYERS-}" ] || grep -q 'Core Validation output' said || fail "$1: the validation layer was not there"
  grep -q '^xrDestroyInstance' log || fail "$1: the instance is not destroyed"
  rm -f messages
}

run() { # ARGS of fulcrum run --xr; $code, and what it says in ./said
  timeout "$limit" "$FULCRUM" run --xr --mute "$@" >said 2>&1
  code=$?
}

# column FOLDER NAME: its values.
column() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } NF >= c { print $c }' "$1/trace.csv"; }

# start ARGS: the same, and goes on; until_seen COMMAND...: waits for it to succeed; 1 if it never does, or if the run ends.
start() {
  rm -f log
  "$FULCRUM" run --xr --mute "$@" >said 2>&1 &
  program=$!
}
until_seen() {
  local end=$((SECONDS + limit)) runs=1
  while ! "$@" 2>/dev/null; do
    [ $runs = 1 ] && [ $SECONDS -lt $end ] || return 1
    kill -0 $program 2>/dev/null || runs=
    sleep 0.1
  done
}
wait_for_end() {
  gone() { ! kill -0 $program 2>/dev/null; }
  until_seen gone || { fail "it does not end: $(cat said)"; kill -9 $program; }
  wait $program
  code=$?
  program=
}

# Of the run in A: how often the force has been stopped, and whether it is. stopped N: so often; back N: and has gone on after.
stops() { column A fault | awk '$1 % 2 { n += !was } { was = $1 % 2 } END { print n + 0, was + 0 }'; }
stopped() { [ -f A/trace.csv ] && [ "$(stops)" = "$1 1" ]; }
back() { [ -f A/trace.csv ] && [ "$(stops)" = "$1 0" ]; }

# No runtime: one sentence, nothing of the loader's, and exit 1. What does not go together is refused.
no_headset() {
  for manifest in "$work/nothing.json" "$work/script"; do
    echo 'no manifest' >script
    XR_RUNTIME_JSON=$manifest run piping --out none
    [ $code = 1 ] || fail "exit $code without a runtime"
    [ "$(wc -l <said)" = 1 ] || fail "more than a sentence without a runtime: $(cat said)"
    grep -q '^fulcrum: --xr needs the OpenXR runtime of a headset, and none is active here: .*XR_RUNTIME_JSON\.$' said ||
      fail "without a runtime it says: $(cat said)"
  done
  [ ! -e none ] || fail "something of a run that was none is left"
  expect 2 '^fulcrum: --xr shows the scene in a headset, and --headless nowhere' "$FULCRUM" run piping --xr --headless
  expect 2 '^fulcrum: --xr has a picture for each eye already: leave out --stereo' "$FULCRUM" run piping --xr --stereo anaglyph
  expect 2 '^fulcrum: --xr draws with the card' "$FULCRUM" run piping --xr --gpu 0
  expect 1 "'mouse' cannot be had: it needs a window: leave out --xr" "$FULCRUM" run piping --xr --device mouse
  expect 1 "'controller' cannot be had: it is there while a headset shows a scene" "$FULCRUM" run piping --headless --realtime --device controller
  mkdir apart && cp "$FULCRUM" apart/fulcrum
  expect 1 'apart/fulcrum-xr, which could not be started .*tools/run --build' apart/fulcrum run piping --xr
  # Nothing of OpenXR is loaded, but for a headset.
  ldd "$FULCRUM" | grep -qi openxr && fail "fulcrum loads OpenXR"
}

# 600 frames, both eyes written in each, while the expert's hand is at work, in a task that no hand completes before.
frames() {
  printf '%s\n' '300 picture quad quad.ppm' '600 exit' >script
  run piping --device simulated --set dwell=600 --set time_limit=3600 --validate --out A
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "600 frames"
  grep -q '^frames 600 left 600 right 600 differing 600$' log || fail "not all frames were written: $(tail -1 log)"
  [ "$(grep -c '^shown 320x320$' log)" = 600 ] || fail "pictures have another size than the runtime recommends"
  [ "$(identify -format '%wx%h' A/frame.png)" = 640x320 ] || fail "frame.png does not have both eyes"
  [ "$(wc -l <A/trace.csv)" -gt 1 ] || fail "the haptic thread did not run"
  has_hand_to_pixel A 500 || fail "how old the tool was when it was seen is not told: $(grep -A 28 hand_to_pixel A/summary.json)"
  # What a window says is on a sheet through what the view looks at, 1.1 times as wide as that is away.
  grep -qE '^quad 1\.15[0-9]* 0\.64[0-9]* at -?0\.0* -0\.30* -1\.003' log || fail "the panel is not where it belongs: $(grep -m 1 '^quad' log)"
  [ "$(identify -format '%k' quad.ppm)" -gt 100 ] || fail "nothing is written on the panel"
  [ -z "${FULCRUM_PICTURES-}" ] || cp quad.ppm "$FULCRUM_PICTURES/"
  # Each frame in its order, the scene's picture within; a panel's comes first, where it is written anew.
  awk '/^xr(WaitFrame|BeginFrame|EndFrame|AcquireSwapchainImage|WaitSwapchainImage|ReleaseSwapchainImage)/ { print $1 }' log |
    paste -sd' ' | sed 's/xrWaitFrame/\nxrWaitFrame/g' | sed '1d; s/ $//; s/BeginFrame\( xrAcquireSwapchainImage xrWaitSwapchainImage xrReleaseSwapchainImage\)\1/BeginFrame\1/' | sort | uniq -c >orders
  grep -qx ' *600 xrWaitFrame xrBeginFrame xrAcquireSwapchainImage xrWaitSwapchainImage xrReleaseSwapchainImage xrEndFrame' orders ||
    fail "frames come in another order: $(cat orders)"
}

# An eye's picture is that which the same camera draws headless: of the scenario's first view, from its own eye, for eyes that
# share a window 1 m away.
picture() {
  echo '{"picture": "best"}' >config/fulcrum/settings.json
  awk 'BEGIN {
    dx = -0.4; dy = -0.3; dz = -0.92; pitch = atan2(dy, sqrt(dx * dx + dz * dz)) / 2
    rad = atan2(0, -1) / 180; tall = sin(17 * rad) / cos(17 * rad); half = 0.0315
    print "size 320 320"; print "eyes 0.063"
    print "fov", -atan2(2 * tall - half, 1), atan2(2 * tall + half, 1), 17 * rad, -17 * rad
    print "1 head 0 0 0", sin(pitch), 0, 0, cos(pitch)
    print "0 picture left left.ppm"; print "0 picture right right.ppm"
  }' >script
  run piping --device simulated --overlay none --seconds 0.001 --out A # what it shows last is its one tick
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well picture
  "$FULCRUM" run piping --headless --stereo side-by-side --eye-distance 63 --convergence 1000 --size 640x320 --overlay none \
    --seconds 0.001 --out B >/dev/null || [ $? = 3 ] || fail "it is not drawn headless"
  convert left.ppm right.ppm +append headset.png
  [ -z "${FULCRUM_PICTURES-}" ] || cp headset.png "$FULCRUM_PICTURES/headset.png"
  # Of the channels' differences: the share that is above 3 of 255.
  differ() { convert "$1" "$2" -compose difference -composite -threshold 1.2% -format '%[fx:mean]' info:; }
  awk -v d="$(differ headset.png B/frame.png)" 'BEGIN { exit !(d < 0.0005) }' ||
    fail "the eyes do not see what is drawn headless: $(differ headset.png B/frame.png) of it differs"
  awk -v d="$(differ left.ppm right.ppm)" 'BEGIN { exit !(d > 0.01) }' || fail "both eyes see the same"
}

# The session is lost without a word, with one, and hidden by something else: each time the force goes, the trial rests, and
# the simulated hand goes on by itself. Taken off and put on again, the headset wants pictures of another size.
lost() {
  printf '%s\n' '30 lose' "40 wait $work/back1" '41 pending' "50 wait $work/back2" '51 hide' "60 wait $work/off3" '61 show' \
    "65 wait $work/back3" '66 size 256 200' '66 rest' "70 wait $work/back4" '100 exit' >script
  start piping --device simulated --out A
  for n in 1 2 3 4; do
    if [ $n = 3 ]; then
      until_seen stopped 3 || fail "the force stays on while something else is seen"
      touch off3
    fi
    until_seen back $n || fail "the force is not back after stop $n: $(stops)"
    touch back$n
  done
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "a session that is lost"
  [ "$(grep -c 'the headset is lost: the force is off, and the trial rests until it is back' said)" = 2 ] || fail "it says: $(cat said)"
  [ "$(grep -c '^xrCreateSession' log)" = 3 ] || fail "no session follows one that is lost"
  [ "$(grep -c '^xrBeginSession' log)" = 4 ] || fail "a headset that is put on again shows nothing"
  [ "$(grep -c '^xrCreateInstance' log)" = 1 ] || fail "another instance is made"
  [ "$(grep -c '^shown 256x200$' log)" -ge 30 ] || fail "pictures do not become as large as is recommended now"
  awk '/^shown 256x200$/ { small = 1 } /^shown 320x320$/ { n += small } END { exit n > 0 }' log || fail "pictures of two sizes are shown by turns"
  [ "$(identify -format '%wx%h' A/frame.png)" = 512x200 ] || fail "frame.png is of another size"
}

# A session that is lost while room is made for its pictures is followed by another one as well.
broken() {
  printf '%s\n' 'size 64 64' '30 break' '30 size 96 64' '30 rest' "40 wait $work/back" '41 exit' >script
  start piping --device simulated --out A
  until_seen back 1 || fail "the force is not back: $(stops), $(cat said)"
  touch back
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "a session that breaks"
  [ "$(grep -c '^xrCreateSession' log)" = 2 ] || fail "no session follows one that is lost"
  [ "$(grep -c 'the headset is lost: ' said)" = 1 ] || fail "it says: $(cat said)"
  grep -q '^shown 96x64$' log || fail "the session that follows shows nothing"
}

# Where the headset has the focus and shows nothing, the force goes as well, and only comes back with the picture.
unseen() {
  printf '%s\n' 'size 64 64' '30 blind' "40 wait $work/off1" '60 sees' "70 wait $work/back1" '71 dark' "80 wait $work/off2" \
    '100 light' "110 wait $work/back2" '111 stall' "117 wait $work/off3" '119 flow' "130 wait $work/back3" '131 exit' >script
  start piping --device simulated --out A
  for n in 1 2 3; do
    until_seen stopped $n || fail "the force stays on while nothing is shown: $(stops)"
    touch off$n
    until_seen back $n || fail "the force is not back after stop $n: $(stops)"
    touch back$n
  done
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "a headset that shows nothing"
  [ "$(stops)" = "3 0" ] || fail "the force comes and goes while nothing is shown: $(stops)"
}

# A runtime that does not say when to draw, for three times as long as it may: the force goes all the same, which is seen once
# it does, and comes back.
hung() {
  printf '%s\n' 'size 64 64' "30 hang $work/go1" "40 wait $work/on1" "50 hang $work/go2" "60 wait $work/on2" '61 exit' >script
  start piping --device simulated --out A
  for n in 1 2; do
    until_seen grep -q "^xrWaitFrame hangs for $work/go$n" log || fail "hang $n does not come: $(tail -1 log)"
    sleep 3
    touch go$n
    until_seen back $n || fail "the force did not go, or is not back, after hang $n: $(stops)"
    touch on$n
  done
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "a runtime that hangs"
  [ "$(stops)" = "2 0" ] || fail "the force comes and goes while the runtime hangs: $(stops)"
}

# A squeeze that begins while the runtime hangs does not go on with the force: the next one does.
hung_squeeze() {
  printf '%s\n' 'size 64 64' 'pace 5' '5 hand right 0.1 -0.2 -0.4' '6 press right select' '15 release right select' \
    '30 press right select' "30 hang $work/go" "40 wait $work/off" '45 release right select' '50 press right select' "60 wait $work/on" \
    '61 exit' >script
  start piping --out A
  until_seen grep -q '^xrWaitFrame hangs for' log || fail "it does not hang: $(tail -1 log)"
  sleep 3
  touch go
  until_seen stopped 1 || fail "the force stays on while the runtime hangs: $(stops)"
  local ticks
  ticks=$(wc -l <A/trace.csv)
  later() { [ "$(wc -l <A/trace.csv)" -gt $((ticks + 500)) ]; }
  until_seen later || fail "no ticks come after the hang"
  stopped 1 || fail "a squeeze that began while the runtime hung goes on: $(stops)"
  grep -q "^fulcrum: the headset's runtime did not answer in time" said || fail "nothing is said of the hang: $(cat said)"
  touch off
  until_seen back 1 || fail "the next squeeze does not go on: $(stops)"
  touch on
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "a squeeze while the runtime hangs"
}

# A squeeze that goes on while something else is seen does not go on with the force: another one does.
held() {
  printf '%s\n' 'size 64 64' 'pace 5' '5 hand right 0.1 -0.2 -0.4' '6 press right select' '30 hide' "40 wait $work/off" '41 show' \
    '70 hide' '80 show' '110 release right select' '115 press right select' "120 wait $work/on" '121 exit' >script
  start piping --out A
  until_seen stopped 1 || fail "the force stays on while something else is seen"
  touch off
  until_seen back 1 || fail "a hand that takes the tool again does not go on: $(stops)"
  touch on
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "a squeeze that goes on"
  [ "$(stops)" = "1 0" ] || fail "a squeeze that never ended brought the force back: $(stops)"
}

# A runtime that is gone, or wants pictures of no size, ends the run with a sentence, wherever that is noticed.
dead() {
  for last in '30 rest' '30 lose'; do
    printf '%s\n' 'size 64 64' "$last" '30 die' >script
    rm -f log
    run piping --device simulated --out A
    [ $code = 3 ] || fail "$last: exit $code: $(cat said)"
    grep -q "^fulcrum: The headset's runtime could not .* (XR_ERROR_INSTANCE_LOST): start it anew" said || fail "$last: it says: $(cat said)"
    grep -q '^WRONG' log && fail "$last: the runtime was called wrongly"
    [ "$(wc -l <A/trace.csv)" -gt 1 ] || fail "$last: what was recorded is lost"
    rm -r A
  done
  echo 'size 64 0' >script
  run piping --device simulated --out B
  [ $code = 1 ] || fail "exit $code where a picture has no size"
  grep -q '^fulcrum: .* wants pictures of 64 x 0 pixels' said || fail "where a picture has no size it says: $(cat said)"
}

# A hand takes the tool, moves it as it moves itself, and leaves it where it is; local space that moves does not.
controllers() {
  {
    echo 'size 64 64'
    echo '5 hand right 0.1 -0.2 -0.4'
    echo '6 press right select'
    for i in $(seq 1 20); do echo "$((10 + i)) hand right $(awk -v i="$i" 'BEGIN { print 0.1 + 0.001 * i }') -0.2 -0.4"; done
    echo "40 wait $work/moved"
    echo '50 recenter 0.3 0 0.1'
    echo '60 release right select'
    echo '62 hand right 0.4 0.2 -0.1'
    echo '70 press right menu' && echo '72 release right menu'
    echo "75 wait $work/stopped"
    echo '80 press right select'
    echo "85 wait $work/gone_on"
    echo '90 exit'
  } >script
  start piping --out A
  # 20 mm to the right of who looks as the view does: its heading is atan2(0.4, 0.92).
  place() { # X Z: the handle has moved so far, within 10 um, and not in height
    [ -f A/trace.csv ] && paste -d' ' <(column A handle/p/x) <(column A handle/p/y) <(column A handle/p/z) |
      awk -v x="$1" -v z="$2" 'NR == 1 { x0 = $1; y0 = $2; z0 = $3 } NF == 3 { a = $1; b = $2; c = $3 }
        function near(p, q) { return (p - q) ^ 2 < 1e-10 } END { exit !(near(a - x0, x) && near(b, y0) && near(c - z0, z)) }'
  }
  right=$(awk 'BEGIN { l = sqrt(0.4 ^ 2 + 0.92 ^ 2); print 0.02 * 0.92 / l, -0.02 * 0.4 / l }')
  # shellcheck disable=SC2086
  until_seen place $right || fail "the handle does not go with the hand: $(tail -1 A/trace.csv | cut -d, -f2-4), of $(sed -n 2p A/trace.csv | cut -d, -f2-4)"
  touch moved
  until_seen stopped 1 || fail "the menu button stops nothing"
  # shellcheck disable=SC2086
  place $right || fail "the handle has moved with local space, or after it was let go"
  touch stopped
  until_seen back 1 || fail "a hand that takes the tool again does not go on"
  touch gone_on
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well controllers
  # shellcheck disable=SC2086
  place $right || fail "the handle has jumped to a hand that took it elsewhere"
}

# What the tool touches is felt in both hands, at the frequency of the scene, and no longer than it lasts.
vibration() {
  {
    echo 'size 64 64'
    echo '5 hand right 0 -0.2 -0.4'
    echo '6 press right select'
    for i in $(seq 1 150); do echo "$((10 + i)) hand right 0 -0.2 $(awk -v i="$i" 'BEGIN { print -0.4 - 0.002 * i }')"; done
    for i in $(seq 1 100); do echo "$((160 + i)) hand right $(awk -v i="$i" 'BEGIN { print 0.04 * sin(i / 8) }') -0.2 -0.7"; done
    echo "261 wait $work/felt"
    echo '270 press right menu'
    echo "280 wait $work/still"
    echo '281 exit'
  } >script
  start piping --out A
  felt() { grep -q "^xrApplyHapticFeedback /user/hand/$1 0\.[1-9].* 233\.0 Hz" log; }
  for hand in left right; do until_seen felt $hand || fail "the $hand controller does not vibrate"; done
  touch felt
  still() { grep -q '^xrStopHapticFeedback /user/hand/right' log; }
  until_seen still || fail "a stop leaves the right controller vibrating"
  touch still
  wait_for_end
  goes_well vibration
}

# A program that is not ours runs on the runtime, too.
hello() {
  command -v hello_xr >/dev/null || { echo "skipped: no hello_xr (apt install libopenxr-utils)"; exit 77; }
  printf '%s\n' '20 hand right 0.2 -0.3 -0.5' '30 press right select' '60 exit' >script
  mkfifo keys # it ends at the first key, and no hand gives one
  exec 9<>keys
  timeout "$limit" hello_xr -g Vulkan2 <keys >said 2>&1
  code=$?
  [ $code = 0 ] || fail "hello_xr: exit $code: $(tail -3 said)"
  goes_well hello_xr
  grep -q '^frames 60 left 60 right 60 differing 60$' log || fail "hello_xr did not show 60 frames: $(tail -1 log)"
}

"$1"
[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
