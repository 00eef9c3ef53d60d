#!/usr/bin/env bash
# A device that is seen where it is felt, on the runtime of the tests' own, as in_headset.sh sets it up.
#   colocated_test.sh WHAT, one of the functions below
. "$(dirname "$(readlink -f "$0")")/in_headset.sh"

# A Touch by its maker's library, in whose place is the tests' own.
touch_is_there() { export LD_LIBRARY_PATH=$STAND_INS; }

# A Touch on a desk, whose base stands at (0.2, 0.9, -0.6) in the stage, turned by 0.5 about the vertical. Three places are
# touched with both tips, after one where the controller is out of sight, and said to be elsewhere. The base is found, kept and
# told; the force is off until the next squeeze.
colocate() {
  touch_is_there
  awk -v work="$work" 'BEGIN {
    print "size 64 64"; print "pace 5"
    split("0.06 -0.02 0.02 -0.07 0 0.01 0.01 0.05 -0.05", p, " ")
    print 20, "handle", p[1], p[2], p[3]; print 21, "wait", work "/at0"
    print 22, "hand right 5 5 5"; print 22, "guess right"; print 25, "press right select"; print 60, "release right select"
    print 62, "track right"
    for (i = 0; i < 3; ++i) {
      f = 100 + 100 * i; x = p[3 * i + 1]; y = p[3 * i + 2]; z = p[3 * i + 3]
      print f, "handle", x, y, z; print f + 1, "wait", work "/at" (i + 1)
      # In local space, 1.5 m over the stage; a hand aims from 20 mm below its grip and 60 mm ahead of that.
      print f + 2, "hand right", 0.2 + cos(0.5) * x + sin(0.5) * z, 0.9 + y - 1.5 + 0.02, -0.6 - sin(0.5) * x + cos(0.5) * z + 0.06
      print f + 5, "press right select"; print f + 50, "release right select"
    }
    print 370, "picture quad quad.ppm"; print 375, "press right menu"; print 380, "release right menu"
    print 390, "wait", work "/kept"
    print 395, "press right select"; print 400, "wait", work "/on"; print 401, "exit"
  }' >script
  start piping --device touch --xr-space stage --colocate --out A
  local n
  told() { [ "$(grep -c '^the handle is there$' log)" -gt "$n" ]; }
  for n in 0 1 2 3; do
    until_seen told || fail "the handle is not moved: $(cat said)"
    later 300
    touch at$n
  done
  kept=config/fulcrum/calibration/touch.xr-stage.yaml
  until_seen [ -f $kept ] || fail "nothing is kept: $(cat said)"
  stopped 1 || fail "something pushes while points are touched: $(stops)"
  touch kept
  until_seen back 1 || fail "the next squeeze does not go on: $(stops)"
  touch on
  wait_for_end
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well colocate
  # Within 20 um of what a pose of 32 bits says; the turn is (w, 0, y, 0) of its half.
  sed -n 's/^base: {position: \[\(.*\)\], orientation: \[\(.*\)\]}$/\1, \2/p' $kept |
    awk -F', ' 'function near(p, q) { return (p - q) ^ 2 < 4e-10 }
      { s = $4 < 0 ? -1 : 1; found = near($1, 0.2) && near($2, 0.9) && near($3, -0.6) && near(s * $4, cos(0.25)) && near(s * $6, sin(0.25)) }
      END { exit !found }' || fail "the base is found elsewhere: $(grep base: $kept)"
  grep -q "^The device stands in stage space as .*touch.xr-stage.yaml has it: residual [0-9.e-]* mm\.$" said || fail "it says: $(cat said)"
  tr -d ' \n' <A/summary.json | grep -qE '"colocation":\{"space":"stage","residual_m":[0-9.e-]+,"residuals_m":\[[0-9.e-]+,[0-9.e-]+,[0-9.e-]+\]\}' ||
    fail "the summary does not tell the residual: $(grep -A 8 colocation A/summary.json)"
  [ "$(identify -format '%k' quad.ppm)" -gt 100 ] || fail "nothing is written on the panel"
  [ -z "${FULCRUM_PICTURES-}" ] || cp quad.ppm "$FULCRUM_PICTURES/colocate.ppm"
  expect 0 'co-location .* the device stands in stage space as .*touch.xr-stage.yaml has it' "$FULCRUM" explain piping --xr --xr-space stage --device touch
  expect 0 'co-location .* no points have been touched in local space .--colocate' "$FULCRUM" explain piping --xr --device touch
  expect 0 'co-location .* has no base that stands on a desk' "$FULCRUM" explain piping --xr
  expect 0 'headset .* --xr asks for it' "$FULCRUM" explain piping --device touch
}

# run_anew ARGS: as run, until the device's samples came in time: a busy machine may keep them from the first tick for so long
# that the force stops, where the trial rests until the script ends it.
run_anew() {
  local end=$((SECONDS + limit))
  while run "$@" && grep -q 'has sent nothing for more than' said && [ $SECONDS -lt $end ]; do
    rm -r "${!#}"
  done
}

# With a device where theory has it, an eye sees what it sees without, from where it would be without: the whole is moved by
# 0.7 about the vertical and a way, and drawn as large as it is felt, by the scale of the scenario's device. No tick differs.
colocated() {
  touch_is_there
  printf '%s\n' 'size 320 320' '0 picture left left.ppm' '1 head 0 -0.3 0.4' '60 exit' >script # 1.2 m over the floor
  run_anew piping --device touch --xr-space stage --xr-scale 0.4 --overlay none --seconds 0.001 --out A
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  mv left.ppm before.ppm
  local handle
  handle=$(for p in x y z; do column A "handle/p/$p" | head -1; done | paste -sd' ')
  mkdir -p config/fulcrum/calibration
  awk -v handle="$handle" 'BEGIN {
    split(handle, h, " "); psi = atan2(0.4, 0.92); a = 0.7 - psi
    # The handle is at its base. Of that in the stage, from the middle of which the view would be had without.
    x = 0.4 * h[1]; y = 0.4 * (h[2] + 1.1 / 0.4); z = 0.4 * (h[3] - 0.03)
    printf "fulcrum: 1\ndevice: touch\nspace: stage\n"
    printf "base: {position: [%.9f, %.9f, %.9f], ", 0.3 + cos(a) * x + sin(a) * z, y - 0.05, -0.2 - sin(a) * x + cos(a) * z
    printf "orientation: [%.9f, 0, %.9f, 0]}\nresiduals: [0.001, 0.002, 0.003]\n", cos(a / 2), sin(a / 2)
  }' >config/fulcrum/calibration/touch.xr-stage.yaml
  awk 'BEGIN {
    print "size 320 320"; print "0 picture left left.ppm"
    print "1 head", 0.3 + sin(0.7) * 0.4, -0.35, -0.2 + cos(0.7) * 0.4, 0, sin(0.35), 0, cos(0.35); print "60 exit"
  }' >script
  run_anew piping --device touch --xr-space stage --overlay none --seconds 0.001 --out B
  [ $code = 3 ] || fail "exit $code: $(cat said)"
  goes_well colocated
  grep -q '"residual_m": 0.00216' B/summary.json || fail "the summary does not tell what was kept"
  [ "$(identify -format '%k' left.ppm)" -gt 500 ] || fail "nothing is seen"
  [ -z "${FULCRUM_PICTURES-}" ] || cp before.ppm left.ppm "$FULCRUM_PICTURES/"
  differ() { convert "$1" "$2" -compose difference -composite -threshold 1.2% -format '%[fx:mean]' info:; }
  # Of a device by the clock, how old its sample is differs each time.
  ticks() { awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "handle/age") age = i } { $age = ""; print }' "$1/trace.csv"; }
  awk -v d="$(differ before.ppm left.ppm)" 'BEGIN { exit !(d < 0.002) }' ||
    fail "it is not seen where theory has it: $(differ before.ppm left.ppm) of it differs"
  [ "$(ticks A | wc -l)" -gt 1 ] && cmp -s <(ticks A) <(ticks B) || fail "where the scene is seen changes the trace"
  printf '%s\n' 'size 320 320' '0 picture left left.ppm' '1 head 0 -0.3 0.4' '60 exit' >script
  run_anew piping --device touch --xr-space stage --overlay none --seconds 0.001 --out C
  awk -v d="$(differ before.ppm left.ppm)" 'BEGIN { exit !(d > 0.02) }' || fail "what is kept moves nothing"
  # A file that is damaged, and what does not go together.
  echo 'fulcrum: 1' >config/fulcrum/calibration/touch.xr-stage.yaml
  expect 0 "co-location .*touch.xr-stage.yaml:1.*'device'" "$FULCRUM" explain piping --xr --xr-space stage --device touch
  run piping --device touch --xr-space stage --out D
  [ $code = 1 ] && [ ! -e D ] || fail "with a damaged file: exit $code"
  grep -q "touch.xr-stage.yaml:1.*'device'" said && grep -q 'touch.xr-stage.yaml: .*anew with --colocate, or remove the file' said ||
    fail "of a damaged file it says: $(cat said)"
  expect 2 '^fulcrum: --colocate .*: add --xr' "$FULCRUM" run piping --colocate
  expect 2 '^fulcrum: --colocate .* leave out --overlay none' "$FULCRUM" run piping --xr --colocate --overlay none
  expect 2 '^fulcrum: --colocate .* leave out --xr-scale' "$FULCRUM" run piping --xr --colocate --xr-scale 2
  expect 1 '^fulcrum: --colocate is for a device with motors .* and simulated is none' "$FULCRUM" run piping --xr --colocate --device simulated
}

# A space that moves takes along what was measured in it: the force goes, and the file with it. The stage does not move with
# local space.
colocated_moves() {
  touch_is_there
  mkdir -p config/fulcrum/calibration
  for space in stage local; do
    printf 'fulcrum: 1\ndevice: touch\nspace: %s\nbase: {position: [0, 1, -0.5], orientation: [1, 0, 0, 0]}\nresiduals: [0, 0, 0]\n' $space \
      >config/fulcrum/calibration/touch.xr-$space.yaml
  done
  printf '%s\n' 'size 64 64' '20 recenter 0.3 0 0.1' '60 exit' >script
  run piping --device touch --xr-space stage --out A
  [ -f config/fulcrum/calibration/touch.xr-stage.yaml ] && ! grep -q 'has moved' said || fail "the stage goes with local space: $(cat said)"
  grep -q '"colocation"' A/summary.json || fail "the stage's place is lost"
  rm -r A
  # Who squeezes in that very picture has not seen yet where the scene is; who does so anew goes on.
  printf '%s\n' 'size 64 64' 'pace 5' '20 recenter 0.3 0 0.1' '20 press right select' "60 wait $work/off" '70 release right select' \
    '75 press right select' "80 wait $work/on" '81 exit' >script
  start piping --device touch --out A
  until_seen stopped 1 || fail "the force stays on where the space has moved: $(stops)"
  later 300
  stopped 1 || fail "a squeeze before the moved scene was seen brings the force back: $(stops)"
  touch off
  until_seen back 1 || fail "a squeeze after that does not go on: $(stops)"
  touch on
  wait_for_end
  goes_well colocated_moves
  grep -q "^fulcrum: the headset's local space has moved in the room, .* anew with --colocate, best with --xr-space stage" said || fail "it says: $(cat said)"
  [ ! -e config/fulcrum/calibration/touch.xr-local.yaml ] || fail "what does not hold any more is kept"
  grep -q '"colocation"' A/summary.json && fail "the summary tells what does not hold any more"
  # So it is while points are touched: what an earlier run kept is of a place that is no more.
  sed 's/space: stage/space: local/' config/fulcrum/calibration/touch.xr-stage.yaml >config/fulcrum/calibration/touch.xr-local.yaml
  printf '%s\n' 'size 64 64' '20 recenter 0.3 0 0.1' '60 exit' >script
  run piping --device touch --colocate --out B
  grep -q "^fulcrum: the headset's local space has moved in the room" said || fail "while points are touched it says: $(cat said)"
  [ ! -e config/fulcrum/calibration/touch.xr-local.yaml ] || fail "what an earlier run kept stays"
}

"$1"
[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
