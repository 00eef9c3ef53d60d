#!/usr/bin/env bash
# A scenario of one's own, made by the program: it runs at once, and its expert carries it out. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
top=$(readlink -f "$(dirname "$(readlink -f "$0")")/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# polygon_tool NAME SIDES LENGTH WIDTH TIP: an OBJ of a pyramid frustum along x, in millimetres; its tip at x = 0.
tool() {
  awk -v n="$2" -v l="$3" -v w="$4" -v t="$5" 'BEGIN {
    for (i = 0; i < n; ++i) printf "v 0 %f %f\n", t * cos(6.2831853 * i / n), t * sin(6.2831853 * i / n)
    for (i = 0; i < n; ++i) printf "v %f %f %f\n", l, w * cos(6.2831853 * i / n), w * sin(6.2831853 * i / n)
    for (i = 0; i < n; ++i) { j = (i + 1) % n; printf "f %d %d %d\nf %d %d %d\n", i+1, j+1, n+j+1, i+1, n+j+1, n+i+1 }
    for (i = 2; i < n; ++i) printf "f %d %d %d\nf %d %d %d\n", 1, i+1, i, n+1, n+i, n+i+1 }' >"$1.obj"
}
# bowl NAME RADIUS DEPTH: an STL, Z up, of a block with a round hollow in it, in millimetres.
bowl() {
  awk -v r="$2" -v d="$3" 'function tri(ax,ay,az,bx,by,bz,cx,cy,cz) { printf "facet normal 0 0 0\nouter loop\nvertex %f %f %f\nvertex %f %f %f\nvertex %f %f %f\nendloop\nendfacet\n", ax,ay,az,bx,by,bz,cx,cy,cz }
    function x(k,i) { return r * k / 12 * cos(6.2831853 * i / 48) } function y(k,i) { return r * k / 12 * sin(6.2831853 * i / 48) } function z(k) { return -d * (1 - (k/12)^2) }
    BEGIN { print "solid bowl"
      for (i = 0; i < 48; ++i) { j = i + 1
        tri(0,0,z(0), x(1,i),y(1,i),z(1), x(1,j),y(1,j),z(1))
        for (k = 1; k < 12; ++k) { tri(x(k,i),y(k,i),z(k), x(k+1,i),y(k+1,i),z(k+1), x(k+1,j),y(k+1,j),z(k+1)); tri(x(k,i),y(k,i),z(k), x(k+1,j),y(k+1,j),z(k+1), x(k,j),y(k,j),z(k)) }
        tri(x(12,i),y(12,i),0, x(12,i),y(12,i),-2*d, x(12,j),y(12,j),-2*d); tri(x(12,i),y(12,i),0, x(12,j),y(12,j),-2*d, x(12,j),y(12,j),0)
        tri(0,0,-2*d, x(12,j),y(12,j),-2*d, x(12,i),y(12,i),-2*d) }
      print "endsolid" }' >"$1.stl"
}

# --- with nothing: a board and a pin
expect 0 'my_first/scenario.yaml is made' "$FULCRUM" new my_first
grep -q 'title: "My first"' my_first/scenario.yaml || fail "the title is not the folder's"
expect 0 '^./my_first: good$' "$FULCRUM" check ./my_first
expect 0 '^\[\]$' "$FULCRUM" check ./my_first --json
expect 0 'Completed' "$FULCRUM" run ./my_first --headless --hand expert --out A
grep -q '"max_penetration_m": 0.0' A/summary.json || fail "the expert's pin is pushed into the board"
expect 1 'my_first is there already' "$FULCRUM" new my_first

# --- the expert's way by doing it: what a run recorded becomes a path that carries the task out as well
expect 0 'redone.yaml: [0-9]+ waypoints for [0-9.]+ s, within 0' "$FULCRUM" path ./my_first A --out redone.yaml
[ "$(grep -c position redone.yaml)" -lt 60 ] || fail "the path has $(grep -c position redone.yaml) waypoints"
expect 1 'redone.yaml is there already' "$FULCRUM" path ./my_first A --out redone.yaml
cp -r my_first redone && cp redone.yaml redone/expert.yaml
expect 0 'good' "$FULCRUM" check ./redone
expect 0 'Completed' "$FULCRUM" run ./redone --headless --hand expert --out R
expect 1 'is a tape' "$FULCRUM" path ./my_first A/tape --out other.yaml
expect 1 'none' "$FULCRUM" path ./my_first none --out other.yaml

# --- with meshes of other programs: several shapes, each from two files to a felt and scored scene
tool probe 12 120 4 0.5
tool stick 4 60 6 5.9
tool chisel 3 250 15 3
bowl dish 60 25
bowl cup 20 30
bowl tray 300 20
for scene in dish cup tray; do
  for hand in probe stick chisel; do
    name=${scene}_$hand
    expect 0 'is made' "$FULCRUM" new "$name" --scene $scene.stl --tool $hand.obj
    expect 0 "^./$name: good" "$FULCRUM" check "./$name"
    "$FULCRUM" check "./$name" | grep 'warning' && fail "$name: something may not feel right"
    expect 0 'Completed' "$FULCRUM" run "./$name" --headless --hand expert --out "run_$name"
  done
done
# The bowl's lowest place is 25 mm deep in its middle: the tip of the probe gets there.
grep -q 'touch, position: \[0, -0.02[45]' dish_probe/scenario.yaml || fail "the dish is not touched at its lowest place: $(grep 'name: touch' dish_probe/scenario.yaml)"

# --- a copy of what is shipped
expect 0 'is made' "$FULCRUM" new copy --from stick
diff <(tail -n +2 copy/scenario.yaml) <(tail -n +2 "$(dirname "$FULCRUM")/content/scenarios/stick/scenario.yaml") || fail "a copy is another one"
for file in copy/scenario.yaml copy/expert.yaml my_first/scenario.yaml my_first/expert.yaml; do
  [ -f "$(sed -n '1s/^# yaml-language-server: $schema=//p' $file)" ] || fail "$file does not name its schema: $(head -n 1 $file)"
done
expect 1 "there is no scenario 'stik'; did you mean 'stick'" "$FULCRUM" new other --from stik

# --- the page for who makes a first one, command by command
mkdir page && cd page || exit 1
fulcrum() { "$FULCRUM" "$@"; }
ran=0
while read -r command; do
  ran=$((ran + 1))
  read -r -a word <<<"$command"
  case $command in
    *--headless*) expect 0 'Completed' "${word[@]}" ;;
    "fulcrum edit "*) # app.edit works it in a window
      expect 1 'display' env -u DISPLAY -u WAYLAND_DISPLAY "$FULCRUM" edit "${word[2]}" ;;
    "fulcrum run "*) expect 3 'Not completed' "${word[@]}" --headless --seconds 0.1 --out "page_$ran" ;;
    *) expect 0 '.' "${word[@]}" ;;
  esac
done < <(grep -E '^    fulcrum' "$top/docs/first-scenario.md")
[ "$ran" -ge 5 ] || fail "only $ran commands were found in docs/first-scenario.md"
cd .. || exit 1

# --- objects that a modelling program has marked, in one file: what is touched, of two materials, what is held, what is seen
mkdir marked && cd marked || exit 1
/usr/bin/python3 - ../my_first/scene.glb ../my_first/tool.glb <<'PY'
import json, struct, sys
def read(file):
    data = open(file, "rb").read()
    end = 20 + struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:end]), data[end + 8:]
all, binary = read(sys.argv[1])
tool, more = read(sys.argv[2])
offset, views, accessors, materials = len(binary), len(all["bufferViews"]), len(all["accessors"]), len(all["materials"])
for view in tool["bufferViews"]:
    all["bufferViews"].append({**view, "byteOffset": view.get("byteOffset", 0) + offset})
for accessor in tool["accessors"]:
    all["accessors"].append({**accessor, "bufferView": accessor["bufferView"] + views})
all["materials"] += tool["materials"]
primitives = [(m["name"], p, 0) for m in all["meshes"] for p in m["primitives"]]
primitives += [("pin", {"attributes": {k: v + accessors for k, v in p["attributes"].items()}, "indices": p["indices"] + accessors,
                        "material": p["material"] + materials}, 1) for m in tool["meshes"] for p in m["primitives"]]
all["meshes"] = [{"name": name, "primitives": [p]} for name, p, _ in primitives]
binary += more
all["buffers"] = [{"byteLength": len(binary)}]
all["scenes"] = [{"nodes": list(range(len(primitives)))}]
def write(name, marks):
    all["nodes"] = [{"name": "object %d" % i, "mesh": i, "extras": mark} for i, mark in enumerate(marks)]
    text = json.dumps(all).encode()
    text += b" " * (-len(text) % 4)
    with open(name, "wb") as file:
        file.write(struct.pack("<4sIII4s", b"glTF", 2, 28 + len(text) + len(binary), len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)
role = lambda r, **more: {"fulcrum_role": r, **more}
write("two.glb", [role("scene", fulcrum_material="wood"), role("scene", fulcrum_material="steel", price=3), role("tool")])
write("seen.glb", [role("scene"), role("decor"), role("tool")])
write("no_tool.glb", [role("scene"), {}, {"name": "tool"}])
write("bare.glb", [{}, {}, {}])
write("numbers.glb", [role(1), role([1]), role({"a": None})])
write("nope.glb", [role("scene", fulcrum_material="nope"), role("decor"), role("tool")])
write("capital.glb", [role("scene"), role("Decor"), role("tool")])
write("odd.glb", [role("scene", fulcrum_material="a}, role: tool"), role("decor"), role("tool")])
PY
expect 0 'is made' "$FULCRUM" new two --scene two.glb
expect_each 0 'scene_wood: .*role: scene, marked: true, material: wood' 'scene_steel: ' 'tool: ' -- cat two/scenario.yaml
expect 0 '^two/scenario.yaml: good$' "$FULCRUM" check two/scenario.yaml
expect 0 'Completed' "$FULCRUM" run two/scenario.yaml --headless --hand expert --out T
grep -q '"max_penetration_m": 0.0' T/summary.json || fail "the marked pin is pushed into the board"
expect 0 'is made' "$FULCRUM" new seen --scene seen.glb
expect 0 'Completed' "$FULCRUM" run seen/scenario.yaml --headless --hand expert --out S
# What is left out of a file is told, and what is not there refused.
sed -i '/scene_steel/d' two/scenario.yaml
expect 0 "'scene.glb' has objects that are marked 'scene' with the material 'steel', which no model takes: add one" "$FULCRUM" check two/scenario.yaml
sed -i 's/material: wood/material: rubber/' two/scenario.yaml
expect 1 "has no object marked with the role 'scene' and the material 'rubber'; some are" "$FULCRUM" check two/scenario.yaml
cp bare.glb two/scene.glb
expect 1 "scenario.yaml:[0-9]+:[0-9]+: .*tick Include > Custom Properties" "$FULCRUM" check two/scenario.yaml
for file in no_tool bare numbers; do
  expect 1 'tick Include > Custom Properties' "$FULCRUM" new half --scene $file.glb
  [ ! -e half ] || fail "half a scenario was left of $file.glb"
done
expect 1 "'a}, role: tool', which is no material that there is" "$FULCRUM" new half --scene odd.glb
expect 1 "'nope', which is no material that there is" "$FULCRUM" new half --scene nope.glb
expect 1 "'object 1' that is marked with the role 'Decor'; did you mean 'decor'" "$FULCRUM" new half --scene capital.glb
cd .. || exit 1

# --- what cannot be
expect 1 'needs what is touched and what is held' "$FULCRUM" new half --scene dish.stl
[ ! -e half ] || fail "half a scenario was left"
expect 2 'say with --scene FILE' "$FULCRUM" new half --tool probe.obj
expect 2 'leave --scene and --tool out' "$FULCRUM" new half --from stick --scene dish.stl --tool probe.obj
expect 1 'none.obj is no file' "$FULCRUM" new half --scene dish.stl --tool none.obj
printf 'v 0 0 0\nv 90 0 0\nv 0 90 0\nf 1 2 3\n' >open.obj
expect 1 'cannot be (held|touched)' "$FULCRUM" new half --scene open.obj --tool probe.obj
[ ! -e half ] || fail "what could not be made was left half done"
expect 1 'cannot be made' "$FULCRUM" new /proc/none

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
