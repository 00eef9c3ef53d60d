#!/usr/bin/env bash
# An author's session under a display without a screen: a bad save leaves the scene and says what is wrong, a good one
# takes over, a checkpoint is dragged and a start is put, and the file shows that and nothing else. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
start_display
cd "$work" || exit 1
export XDG_DATA_HOME=$work/data
"$FULCRUM" new mine >/dev/null || exit 1
file=mine/scenario.yaml

says() { grep -qE -- "$1" said; }
reads() { grep -c 'has been read' said; }
read_more() { [ "$(reads)" -gt "$1" ]; }
alive() { kill -0 $program 2>/dev/null; }

"$FULCRUM" edit piping >said 2>&1
[ $? = 2 ] && says 'copy it with `fulcrum new MINE --from piping`' || fail "a shipped scenario is edited: $(cat said)"

"$FULCRUM" edit $file --device mouse --validate --size 640x360 >>said 2>&1 &
program=$!
window=
until_seen find_window
[ -n "$window" ] || { cat said; echo "FAILED: no window"; exit 1; }
xdotool windowactivate --sync "$window"
coloured() { shot seen && [ "$(identify -format %k "$work/seen.png")" -gt 200 ]; }
until_seen coloured || fail "the window shows no picture"

# --- saves: bad ones leave the scene, good ones take over, and as much as one likes
cp $file good.yaml
for round in 1 2 3; do
  sed "s/time_limit: 60/time_limit: soon/" good.yaml >$file
  until_seen says "mine/scenario.yaml:[0-9]+:13: 'time_limit' must be a number" || fail "round $round: a bad save is not told: $(cat said)"
  coloured || fail "round $round: the scene is gone"
  had=$(reads)
  sed "s/time_limit: 60/time_limit: 6$round/" good.yaml >$file
  until_seen read_more "$had" || fail "round $round: a good save is not read: $(cat said)"
  until_seen coloured || fail "round $round: the new scene is not seen"
  : >said
done
had=$(reads)
cp good.yaml $file
until_seen read_more "$had" || fail "the first text is not read again: $(cat said)"
until_seen coloured

# pixel X Y Z: where the first view has a place, in a picture of 640 by 360.
pixel() {
  /usr/bin/python3 - $file "$@" <<'PY'
import math, re, sys
text = open(sys.argv[1]).read()
view = re.search(r"name: overview, eye: \[(.*?)\], target: \[(.*?)\], fov_deg: (\d+)", text)
eye, target = ([float(x) for x in view.group(i).split(",")] for i in (1, 2))
p = [float(x) for x in sys.argv[2:5]]
sub = lambda a, b: [x - y for x, y in zip(a, b)]
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
unit = lambda a: [x / math.sqrt(dot(a, a)) for x in a]
cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
forward = unit(sub(target, eye))
right = unit(cross(forward, [0, 1, 0]))
up = cross(right, forward)
d = sub(p, eye)
f = 180 / math.tan(math.radians(float(view.group(3))) / 2)
print(round(320 + f * dot(d, right) / dot(d, forward)), round(180 - f * dot(d, up) / dot(d, forward)))
PY
}
# changed PATTERN: of the lines that differ from the first text, each has it, and there is one at least.
changed() {
  diff good.yaml $file >diff.txt && { fail "nothing is written"; return; }
  ! grep '^[<>]' diff.txt | grep -vE -- "$1" || fail "more is written than $1"
}

# --- a checkpoint is dragged with Control held, 40 px to the right
place=$(sed -n 's/.*name: touch, position: \[\(.*\)\], radius.*/\1/p' $file | tr -d ',')
read -r x y <<<"$(pixel $place)"
had=$(reads)
xdotool mousemove --sync --window "$window" "$x" "$y" keydown Control mousedown 1
for step in 1 2 3 4; do xdotool mousemove --window "$window" $((x + 10 * step)) "$y"; done
xdotool mouseup 1 keyup Control
until_seen read_more "$had" || fail "a dragged checkpoint is not written: $(cat said)"
changed 'name: touch, position'
now=$(sed -n 's/.*name: touch, position: \[\(.*\)\], radius.*/\1/p' $file | tr -d ',')
read -r x_now y_now <<<"$(pixel $now)"
[ $(((x_now - x - 40) ** 2 + (y_now - y) ** 2)) -le 8 ] || fail "it was at $x $y, and is at $x_now $y_now"

# --- the start is put where the tool is, as soon as that has moved
cp $file good.yaml
until_seen coloured
had=$(reads)
xdotool mousemove --sync --window "$window" 320 180 mousedown 1
for step in 1 2 3 4; do xdotool mousemove --window "$window" $((320 + 5 * step)) 180; done
xdotool mouseup 1
xdotool key --window "$window" F8
xdotool key --window "$window" F8
puts() {
  xdotool key --window "$window" F9
  ! diff -q good.yaml $file >/dev/null
}
until_seen puts || fail "the start is not written: $(cat said)"
until_seen read_more "$had" || fail "the start is not read again: $(cat said)"
changed 'start:'

# --- and what was wrong with nothing: Vulkan, the end
says 'Validation' && fail "Vulkan complains: $(cat said)"
alive || fail "it has ended: $(cat said)"
kill -HUP $program
wait_for_end
[ "$code" = 0 ] || fail "exit code $code: $(cat said)"
[ -z "$(ls "$XDG_DATA_HOME/fulcrum/runs" 2>/dev/null)" ] || fail "a run was recorded"

exit $((failures > 0))
