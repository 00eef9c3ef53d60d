#!/usr/bin/env bash
# From the mesh of another program to a scenario that is felt. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# box NAME LOW HIGH: an OBJ of a box, corners in millimetres.
box() {
  { echo "# a box"
    for z in 0 1; do for y in 0 1; do for x in 0 1; do
      read -r lx ly lz <<<"$2" && read -r hx hy hz <<<"$3"
      echo "v $([ $x = 0 ] && echo "$lx" || echo "$hx") $([ $y = 0 ] && echo "$ly" || echo "$hy") $([ $z = 0 ] && echo "$lz" || echo "$hz")"
    done; done; done
    printf 'f %s %s %s\n' 1 5 7 1 7 3 2 4 8 2 8 6 1 2 6 1 6 5 3 7 8 3 8 4 1 3 4 1 4 2 5 6 8 5 8 7
  } >"$1.obj"
}
box block "-100 -20 -100" "100 0 100"
box peg "-5 0 -5" "5 40 5"

# --- what is told, and where it goes
expect 0 'block.obj -> block.glb' "$FULCRUM" import block.obj
expect 0 '200 x 20 x 200 mm' "$FULCRUM" import block.obj --force
expect 0 'Taken in millimetres, since it is 284 units across' "$FULCRUM" import block.obj --force
expect 1 'block.glb is there already: --force replaces it' "$FULCRUM" import block.obj
expect 0 '2000 x 200 x 2000 mm|2 x 0.2 x 2 m' "$FULCRUM" import block.obj --force --unit cm
expect 0 '"unit_m": 0.001' "$FULCRUM" import block.obj --force --json
mkdir own
expect 0 'peg.obj -> own/peg.glb' "$FULCRUM" import block.obj peg.obj --out own
expect 1 'names one .glb, and there are 2 files' "$FULCRUM" import block.obj peg.obj --out own/a.glb
expect 2 'unit' "$FULCRUM" import block.obj --unit furlong
expect 1 'missing.obj: No such file' "$FULCRUM" import missing.obj
expect 1 'is the file that is read' "$FULCRUM" import own/peg.glb --out own --force

# --- two that would become one are both left as they are, whatever is replaced
mkdir -p twin pair
sed 's/^# a box/&, another/' block.obj >twin/block.obj
expect 1 'block.obj and twin/block.obj would both become pair/block.glb: import one at a time' \
  "$FULCRUM" import block.obj twin/block.obj --out pair --force
cp peg.obj twin/block_drawn.obj
expect 1 'would both become pair/block_drawn.glb' \
  "$FULCRUM" import block.obj twin/block_drawn.obj --out pair --simplify 0.1
[ -z "$(ls pair)" ] || fail "something was written: $(ls pair)"

# --- what its materials have and the model has not
printf 'newmtl lamp\nKd 1 1 1\nd 0.2\nKe 5 5 0\n' >lamp.mtl
{ printf 'mtllib lamp.mtl\nusemtl lamp\n' && cat block.obj; } >lamp.obj
expect 0 'Of its materials opacity and emission are left out' "$FULCRUM" import lamp.obj
expect 0 '"materials_left_out": \[' "$FULCRUM" import lamp.obj --force --json
expect 0 '"emission"' "$FULCRUM" import lamp.obj --force --json

# --- a folder that cannot be written leaves nothing half done
mkdir full && chmod 500 full
[ "$(id -u)" = 0 ] || expect 1 'cannot be written' "$FULCRUM" import peg.obj --out full
expect 1 'cannot be written' "$FULCRUM" import peg.obj --out /proc/none

# --- the mesh's own name, where a model or a scenario is wanted
cat >own/scenario.yaml <<'YAML'
fulcrum: 1
title: Peg
about: A peg on a block.
time_limit: 2
models:
  block: {file: block.glb, role: scene}
  peg: {file: peg.glb, role: tool}
tool: {start: {position: [0, 0.03, 0]}}
device: {model: phantom_like}
checkpoints:
  - {name: middle, position: [0, 0, 0], radius: 0.005}
views:
  - {name: front, eye: [0, 0.1, 0.5], target: [0, 0, 0]}
YAML
expect 0 'good' "$FULCRUM" check ./own
expect 3 'middle' "$FULCRUM" run ./own --headless --hand still --seconds 0.1 --out A
sed 's/peg.glb/peg.obj/' own/scenario.yaml >own/mesh.yaml && cp peg.obj own
expect 1 '`fulcrum import peg.obj` makes a .glb of it' "$FULCRUM" check own/mesh.yaml
expect 1 "'peg.obj' is a model, and no scenario: .fulcrum import. makes a .glb" "$FULCRUM" run peg.obj
expect 1 "'own/peg.glb' is a model, and no scenario" "$FULCRUM" check own/peg.glb

# --- what is drawn may be coarser than what is felt
sed 's/peg.glb,/peg.glb, drawn: block.glb,/' own/scenario.yaml >own/drawn.yaml
expect 0 'good' "$FULCRUM" check own/drawn.yaml
sed 's/role: tool/role: tool, drawn: none.glb/' own/scenario.yaml >own/drawn.yaml
expect 1 "drawn.yaml:7:[0-9]+: model 'peg': .*none.glb" "$FULCRUM" check own/drawn.yaml

# --- without the program that reads meshes
mkdir apart && cp "$FULCRUM" apart/
expect 1 'apart/fulcrum-import, which could not be started .*tools/run --build' apart/fulcrum import peg.obj

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
