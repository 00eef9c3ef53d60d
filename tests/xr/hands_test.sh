#!/usr/bin/env bash
# Hands without controllers in a headset (--device tracked_hand), on the runtime of the tests' own, as in_headset.sh sets it up.
#   hands_test.sh WHAT, one of the functions below
. "$(dirname "$(readlink -f "$0")")/in_headset.sh"

# A pinch takes the tool, which goes with the palm as long as the fingers are no farther than they may be, and stays where it is
# let go. Thumb and little finger stop. What was recorded is the same again, to the bit.
held() {
  {
    printf '%s\n' 'size 64 64' 'pace 5' '5 bare right 0.1 -0.2 -0.4' '7 bare right 0.13 -0.2 -0.4' '8 bare right 0.1 -0.2 -0.4'
    echo '10 tips right 21 80' # no pinch yet
    echo '12 bare right 0.13 -0.2 -0.4' && echo '13 bare right 0.1 -0.2 -0.4'
    echo '15 tips right 10 80'
    for i in $(seq 1 20); do echo "$((20 + i)) bare right $(awk -v i="$i" 'BEGIN { print 0.1 + 0.001 * i }') -0.2 -0.4"; done
    echo "41 wait $work/moved"
    echo '42 tips right 34 80' # a pinch yet
    echo '43 bare right 0.12 -0.2 -0.42'
    echo "44 wait $work/farther"
    echo '45 tips right 36 80'
    echo '50 bare right 0.2 -0.2 -0.3'
    echo '60 tips right 80 10' && echo '62 tips right 80 80'
    echo "65 wait $work/stopped"
    echo '70 tips right 10 80'
    echo "75 wait $work/on"
    echo '76 exit'
  } >script
  start piping --device tracked_hand --out A
  local right farther
  right=$(in_world 0.02 0) farther=$(in_world 0.02 -0.02)
  # shellcheck disable=SC2086
  until_seen went $right || fail "the handle does not go with the hand: $(tail -1 A/trace.csv | cut -d, -f2-4)"
  touch moved
  # shellcheck disable=SC2086
  until_seen went $farther || fail "fingers that open a little let go, or move the handle: $(tail -1 A/trace.csv | cut -d, -f2-4)"
  touch farther
  until_seen stopped 1 || fail "thumb and little finger stop nothing: $(stops)"
  has_fault $stop_requested || fail "the stop is another: $(column A fault | tail -1)"
  # shellcheck disable=SC2086
  went $farther || fail "the handle has moved since it was let go"
  touch stopped
  until_seen back 1 || fail "a pinch does not go on"
  touch on
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well held
  grep -q '^with XR_EXT_hand_tracking$' log || fail "hands are not asked for"
  [ "$(grep -c '^xrCreateHandTrackerEXT' log)" = 2 ] && [ "$(grep -c '^xrDestroyHandTrackerEXT' log)" = 2 ] || fail "not each hand has a tracker"
  grep -q '^xrApplyHapticFeedback' log && fail "a hand without a controller is told to vibrate"
  tr -d ' \n' <A/summary.json | grep -q '"device":"tracked_hand"' || fail "the summary tells another device"
  "$FULCRUM" replay A/tape --out B >replayed 2>&1 || [ $? = 3 ] || fail "it is not replayed: $(cat replayed)"
  cmp A/trace.csv B/trace.csv || fail "a replay differs"
}

# A turn of the hand is one about what it holds: tips that are 10 mm apart have it 25 mm below, 80 mm before and 20 mm left of
# the palm. The palm turns by 0.3 about the vertical, in ten steps.
turned() {
  {
    printf '%s\n' 'size 64 64' 'pace 5' '5 bare right 0.1 -0.2 -0.4' '8 tips right 10 80'
    for i in $(seq 1 10); do echo "$((20 + i)) bare right 0.1 -0.2 -0.4 0 $(awk -v i="$i" 'BEGIN { a = 0.015 * i; print sin(a), 0, cos(a) }')"; done
    echo "40 wait $work/seen" && echo '41 exit'
  } >script
  start piping --device tracked_hand --out A
  # shellcheck disable=SC2046,SC2086
  until_seen went $(in_world $(awk 'BEGIN { a = 0.3; x = -0.02; z = -0.08; print (cos(a) - 1) * x + sin(a) * z, -sin(a) * x + (cos(a) - 1) * z }')) ||
    fail "the handle does not go where what is held goes: $(tail -1 A/trace.csv | cut -d, -f2-4), of $(sed -n 2p A/trace.csv | cut -d, -f2-4)"
  has_turned() {
    paste -d' ' <(column A handle/q/w) <(column A handle/q/x) <(column A handle/q/y) <(column A handle/q/z) |
      awk 'NR == 1 { w = $1; x = $2; y = $3; z = $4 } NF == 4 { d = w * $1 + x * $2 + y * $3 + z * $4 }
        END { d = d < 0 ? -d : d; exit !((d - cos(0.15)) ^ 2 < 1e-10) }'
  }
  until_seen has_turned || fail "the handle turns by something else: $(tail -1 A/trace.csv | cut -d, -f5-8)"
  touch seen
  wait_for_end
  goes_well turned
}

# Out of sight for 100 ms while it holds: the force stops, and the summary and the trace say of what. Back and still pinched it
# does not go on, pinched anew it does, and nothing jumps to where it is by then.
covered() {
  {
    printf '%s\n' 'size 64 64' 'pace 5' '5 bare right 0.1 -0.2 -0.4' '8 tips right 10 80' '20 cover right'
    echo "30 wait $work/off"
    echo '31 bare right 0.4 0.1 -0.2' && echo '32 uncover right'
    echo "50 wait $work/still_off"
    echo '51 tips right 60 80' && echo '55 tips right 10 80'
    echo "60 wait $work/on"
    echo '61 exit'
  } >script
  start piping --device tracked_hand --out A
  until_seen has_fault $sample_stale || fail "a hand that nobody sees stops nothing: $(column A fault | tail -1)"
  touch off
  until_seen grep -q '^xrWaitFrame 49' log || fail "no pictures come: $(tail -1 log)"
  later 300
  has_fault $sample_stale || fail "a hand that comes back pinched goes on"
  touch still_off
  until_seen has_no_fault || fail "a pinch does not go on: $(column A fault | tail -1)"
  went 0 0 || fail "the handle has jumped: $(tail -1 A/trace.csv | cut -d, -f2-4)"
  touch on
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well covered
  tr -d ' \n' <A/summary.json | grep -q '"faults":\[[^]]*"sample_stale"' || fail "the summary does not tell it: $(grep -A 5 '"faults"' A/summary.json)"
}

# What is said of a palm is no place, or one that no hand can have gone to: it is out of sight then, and nothing of that is a
# motion.
spoilt() {
  {
    printf '%s\n' 'size 64 64' 'pace 5' '5 bare right 0.1 -0.2 -0.4' '8 tips right 10 80'
    local frame=20 how
    for how in nan unturned far; do
      echo "$frame spoil right $how"
      echo "$((frame + 5)) wait $work/off_$how"
      echo "$((frame + 6)) spoil right well" && echo "$((frame + 8)) tips right 60 80" && echo "$((frame + 10)) tips right 10 80"
      echo "$((frame + 15)) wait $work/on_$how"
      frame=$((frame + 20))
    done
    # From one picture to the next by half a metre, and back: taken anew, twice.
    echo '85 bare right 0.6 -0.2 -0.4' && echo '90 bare right 0.1 -0.2 -0.4'
    echo "95 wait $work/leapt" && echo '96 exit'
  } >script
  start piping --device tracked_hand --out A
  for how in nan unturned far; do
    until_seen has_fault $sample_stale || fail "$how: the force stays on: $(column A fault | tail -1)"
    touch "off_$how"
    until_seen has_no_fault || fail "$how: a pinch does not go on: $(column A fault | tail -1)"
    touch "on_$how"
  done
  until_seen grep -q '^xrWaitFrame 94' log || fail "no pictures come: $(tail -1 log)"
  later 300
  went 0 0 || fail "the handle has moved: $(tail -1 A/trace.csv | cut -d, -f2-4)"
  # Where the machine shows no picture for 100 ms, the one in which it is out of sight is enough.
  has_no_fault || has_fault $sample_stale || fail "a hand that leaps stops the force: $(column A fault | tail -1)"
  touch leapt
  wait_for_end
  goes_well spoilt
  column A fault | awk -v bit=$not_finite 'int($1 / bit) % 2 { bad = 1 } END { exit bad }' || fail "what is no place came as far as a tick"
  went 0 0 || fail "the handle has moved: $(tail -1 A/trace.csv | cut -d, -f2-4)"
}

# Another session has other trackers. The other hand takes the tool where the first one is gone.
another() {
  {
    printf '%s\n' 'size 64 64' 'pace 5' '5 bare right 0.1 -0.2 -0.4' '8 tips right 10 80' '30 lose'
    echo "60 wait $work/lost" && echo '61 tips right 80 80' && echo '65 tips right 10 80'
    echo "70 wait $work/on" && echo '75 cover right'
    echo "80 wait $work/off" && echo '81 bare left -0.1 -0.2 -0.4' && echo '85 tips left 10 80'
    echo "90 wait $work/left" && echo '91 exit'
  } >script
  start piping --device tracked_hand --out A
  until_seen stopped 1 || fail "the force stays on while the headset is lost"
  until_seen grep -q '^xrWaitFrame 59' log || fail "no session follows: $(tail -1 log)"
  later 300
  stopped 1 || fail "a pinch that began before goes on"
  touch lost
  until_seen back 1 || fail "a pinch does not go on in another session"
  touch on
  until_seen has_fault $sample_stale || fail "a hand that nobody sees stops nothing"
  touch off
  until_seen has_no_fault || fail "the other hand does not go on: $(column A fault | tail -1)"
  touch left
  wait_for_end
  goes_well another
  [ "$(grep -c '^xrCreateHandTrackerEXT' log)" = 4 ] && [ "$(grep -c '^xrDestroyHandTrackerEXT' log)" = 4 ] || fail "trackers of hands do not go with their session"
}

# A runtime without the extension, and a headset that is told not to: a sentence each, and nothing is run. Who does not ask for
# hands has none of it, which explain tells.
none() {
  printf '%s\n' 'size 64 64' 'tracking none' >script
  run piping --device tracked_hand --out A
  [ $code = 1 ] && [ ! -e A ] || fail "exit $code without the extension"
  grep -qx 'fulcrum: The active OpenXR runtime tracks no hands (XR_EXT_hand_tracking): update it, or take its controllers (--device controller)\.' said ||
    fail "without the extension it says: $(cat said)"
  printf '%s\n' 'size 64 64' 'tracking off' >script
  run piping --device tracked_hand --out A
  [ $code = 1 ] && [ ! -e A ] || fail "exit $code where the headset tracks none"
  grep -q '^fulcrum: The headset, a headset of paper, tracks no hands, or is told not to: .* (--device controller)\.$' said ||
    fail "where the headset tracks none it says: $(cat said)"
  printf '%s\n' 'size 64 64' '20 exit' >script
  run piping --out A
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well none
  grep -q 'XR_EXT_hand_tracking\|HandTracker' log && fail "hands are tracked that nobody asked for"
  expect 0 'hand tracking .* 26 joints' "$FULCRUM" explain piping --xr --device tracked_hand
  expect 0 'hand tracking .* --device tracked_hand asks for it' "$FULCRUM" explain piping --xr --device controller
  expect 1 "'tracked_hand' cannot be had: it is there while a headset shows a scene" "$FULCRUM" run piping --headless --realtime --device tracked_hand
  expect 1 "Nothing vibrates by 'tracked_hand'" "$FULCRUM" run piping --xr --device mouse+tracked_hand
}

"$1"
[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
