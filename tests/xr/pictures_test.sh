#!/usr/bin/env bash
# What a headset shows, on the runtime of the tests' own, as in_headset.sh sets it up.
#   pictures_test.sh WHAT, one of the functions below
. "$(dirname "$(readlink -f "$0")")/../support/hand_to_pixel.sh"
. "$(dirname "$(readlink -f "$0")")/in_headset.sh"

# 600 frames, both eyes written in each, while the expert's hand is at work, in a task that no hand completes before.
frames() {
  printf '%s\n' 'pace 5' '300 picture quad quad.ppm' '600 exit' >script
  run piping --device simulated --set dwell=600 --set time_limit=3600 --validate --out A
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "600 frames"
  grep -q '^frames 600 left 600 right 600 differing 600$' log || fail "not all frames were written: $(tail -1 log)"
  [ "$(grep -c '^shown 320x320$' log)" = 600 ] || fail "pictures have another size than the runtime recommends"
  [ "$(identify -format '%wx%h' A/frame.png)" = 640x320 ] || fail "frame.png does not have both eyes"
  [ "$(wc -l <A/trace.csv)" -gt 1800 ] || fail "the haptic thread ran at no pace of its own: $(wc -l <A/trace.csv) ticks in 600 frames"
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

# A runtime whose pictures are as wide as one eye's is to be, and which shows them over the room: each eye's is as much smaller,
# and goes with the room as the headset can.
narrow() {
  printf '%s\n' 'size 320 240' 'largest 320 4096' 'blend additive' '30 exit' >script
  run piping --device simulated --overlay none --out A
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "narrow pictures"
  [ "$(grep -c '^shown 160x120$' log)" -ge 20 ] || fail "pictures of another size are shown: $(grep '^shown' log | sort | uniq -c)"
  grep -q '160 x 120 for each eye' said || fail "it says: $(cat said)"
}

# What came of a trial is on the panel once it has ended, until a squeeze that begins then; taken off, nobody is waited for.
card() {
  local i
  {
    printf '%s\n' 'size 64 64' 'pace 5' '5 hand right 0 -0.2 -0.4' '2 picture quad before.ppm' "40 wait $work/ended"
    echo '0 picture quad card.ppm'
    for i in $(seq 100 20 500); do echo "$i press right select" && echo "$((i + 10)) release right select"; done
  } >script
  start piping --device simulated --seconds 0.5 --out A
  has_ended() { [ -f A/trace.csv ] && [ "$(wc -l <A/trace.csv)" = 501 ]; }
  until_seen has_ended || fail "the trial does not end: $(cat said)"
  touch ended
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well card
  grep -q '^xrWaitFrame 99$' log || fail "nobody is shown what came of it: $(tail -1 log)"
  # The card lies in the middle, where nothing is before.
  middle() { convert "$1" -crop 300x120+490+280 -format '%[fx:mean]' info:; }
  awk -v b="$(middle before.ppm)" -v a="$(middle card.ppm)" 'BEGIN { exit !(b < 0.001 && a > 0.01) }' ||
    fail "what came of it is not on the panel: $(middle before.ppm) before, $(middle card.ppm) after"
  [ -z "${FULCRUM_PICTURES-}" ] || cp card.ppm "$FULCRUM_PICTURES/card.ppm"
  rm -r A ended
  # While somebody looks at it, all of the trial is kept already.
  echo 'size 64 64' >script
  export XDG_DATA_HOME=$work/data
  start piping --device simulated --seconds 0.5 --participant K --out A
  until_seen test -s A/report.html || fail "nothing is kept while the card is shown: $(cat said)"
  kill -9 $program
  wait $program 2>/dev/null
  program=
  "$FULCRUM" results | grep -q '^ *K ' || fail "a trial is lost that ended in a headset: $("$FULCRUM" results)"
  rm -r A
  printf '%s\n' 'size 64 64' "40 wait $work/ended" '60 rest' >script
  start piping --device simulated --seconds 0.5 --out A
  until_seen has_ended || fail "the trial does not end: $(cat said)"
  touch ended
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well "taken off after the end"
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
