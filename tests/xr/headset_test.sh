#!/usr/bin/env bash
# Sessions and controllers of a headset, on the runtime of the tests' own, as in_headset.sh sets it up.
#   headset_test.sh WHAT, one of the functions below
. "$(dirname "$(readlink -f "$0")")/in_headset.sh"

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
  for device in mouse keyboard gamepad mouse+audio; do
    expect 1 "^fulcrum: The device '${device%+*}' cannot be had: it needs a window: leave out --xr, or --device\.$" "$FULCRUM" explain piping --xr --device $device
  done
  expect 0 '^  headset ' "$FULCRUM" explain piping --xr --device touch
  expect 1 "'controller' cannot be had: it is there while a headset shows a scene" "$FULCRUM" run piping --headless --realtime --device controller
  mkdir apart && cp "$FULCRUM" apart/fulcrum
  expect 1 'apart/fulcrum-xr, which could not be started .*tools/run --build' apart/fulcrum run piping --xr
  # Nothing of OpenXR is loaded, but for a headset.
  ldd "$FULCRUM" | grep -qi openxr && fail "fulcrum loads OpenXR"
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
  column A fault | awk -v bit=$unanswered '$1 % 2 { bad = 1 } int($1 / bit) % 2 { hung = 1 } END { exit !hung || bad }' || fail "the trace has the hang as another stop"
  tr -d ' \n' <A/summary.json | grep -q '"faults":\[{"name":"unanswered"' || fail "the summary does not tell of the hang: $(grep -A 5 '"faults"' A/summary.json)"
}

# A picture may take 5 s, for machines that draw slowly, and no longer: a runtime that hangs as it takes one. The force is off from
# then on, and nobody who is not seen to go on brings it back.
jammed() {
  printf '%s\n' 'size 64 64' 'pace 5' '5 hand right 0.1 -0.2 -0.4' '6 press right select' '15 release right select' \
    "30 hang $work/go xrEndFrame" "90 wait $work/off" '91 exit' >script
  start piping --out A
  until_seen grep -q '^xrEndFrame hangs for' log || fail "it does not hang: $(tail -1 log)"
  local rows
  rows=$(wc -l <A/trace.csv)
  sleep 7
  touch go
  until_seen stopped 1 || fail "the force stays on while a picture takes longer than 5 s: $(stops)"
  later 500
  stopped 1 && has_fault $unanswered || fail "the force is back by itself: $(column A fault | tail -1)"
  touch off
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "a picture that takes too long"
  # Ticks that a busy machine loses are not in the trace.
  column A fault | awk -v rows="$rows" '$1 % 65536 > 0 && !gone { gone = NR } END { exit !(gone > rows + 2000) }' ||
    fail "the force goes earlier, at tick $(column A fault | awk '$1 % 65536 > 0 { print NR }' | sed -n 1p) where the runtime hung at $rows"
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
  later 500
  stopped 1 && has_fault $unanswered || fail "a squeeze that began while the runtime hung goes on: $(stops)"
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
  printf '%s\n' 'size 64 64' '30 ending' >script
  run piping --device simulated --out A
  [ $code = 3 ] || fail "exit $code where the runtime is about to end: $(cat said)"
  grep -qx "fulcrum: The headset's runtime ends: start it anew, and this run with it\." said || fail "where the runtime is about to end it says: $(cat said)"
  goes_well "a runtime that ends"
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
  right=$(in_world 0.02 0) # of who looks as the view does
  # shellcheck disable=SC2086
  until_seen went $right || fail "the handle does not go with the hand: $(tail -1 A/trace.csv | cut -d, -f2-4), of $(sed -n 2p A/trace.csv | cut -d, -f2-4)"
  touch moved
  until_seen stopped 1 || fail "the menu button stops nothing"
  # shellcheck disable=SC2086
  went $right || fail "the handle has moved with local space, or after it was let go"
  touch stopped
  until_seen back 1 || fail "a hand that takes the tool again does not go on"
  touch gone_on
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well controllers
  # shellcheck disable=SC2086
  went $right || fail "the handle has jumped to a hand that took it elsewhere"
}

# A controller that sleeps says nothing: a squeeze that was there before, or began meanwhile, does not go on after a stop.
asleep() {
  {
    printf '%s\n' 'size 64 64' 'pace 5' '5 hand right 0.1 -0.2 -0.4' '10 press right select' '30 press right menu' '32 release right menu'
    echo "40 wait $work/stopped"
    printf '%s\n' '41 sleep right' '50 wake right' '60 sleep right' '61 release right select' '65 press right select' '70 wake right'
    echo "100 wait $work/still" && echo '101 release right select' && echo '105 press right select'
    echo "110 wait $work/gone_on" && echo '111 exit'
  } >script
  start piping --out A
  until_seen stopped 1 || fail "the menu button stops nothing"
  touch stopped
  until_seen grep -q '^xrWaitFrame 99' log || fail "no pictures come: $(tail -1 log)"
  later 300
  stopped 1 || fail "a squeeze that nobody saw begin goes on"
  touch still
  until_seen back 1 || fail "a squeeze does not go on"
  touch gone_on
  wait_for_end
  goes_well asleep
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

"$1"
[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
