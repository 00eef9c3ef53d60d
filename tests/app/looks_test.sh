#!/usr/bin/env bash
# What of a model's looks is not drawn, and what of a scenario's changes nothing, `fulcrum check` says, with the file's name at
# its line, and `fulcrum explain` builds nothing for it. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

"$FULCRUM" new looks >/dev/null || fail "no scenario could be made"
sed -i 's/^models:$/&\n  part: {file: part.gltf, role: decor, position: [0.05, 0, 0]}/' looks/scenario.yaml
line=$(grep -n 'part.gltf' looks/scenario.yaml | cut -d: -f1)
check() { "$FULCRUM" check "looks/${1:-scenario.yaml}"; }

# A tetrahedron of 2 cm of the material $1; $2: members of the top object, $3: of its node, $4: of its primitive, $5: more primitives.
part() {
  cat >looks/part.gltf <<GLTF
{"asset":{"version":"2.0"},$2"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0$3}],"materials":[{"name":"shell"$1}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0$4}$5]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[0.02,0.02,0.02]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAACtejPAAAAAAAAAAAAAAAAArXozwAAAAAAAAAAAAAAAAK16M8AAACAAEAAAABAAMAAAADAAIAAQACAAMA"}]}
GLTF
}
told="scenario.yaml:$line:[0-9]+: model 'part': 'part.gltf' is drawn without"

part '' '' '' '' ''
check | grep 'drawn without' && fail "what a file does not have is told of"
part '' '"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}],"samplers":[{"input":0,"output":0}]}],' \
  ',"skin":0' ',"targets":[{"POSITION":0}]' ',{"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},"mode":1}'
sed -i 's/"materials"/"skins":[{"joints":[0]}],&/' looks/part.gltf
expect_each 0 "$told.* points, which are no surface" "$told.* lines, which are no surface" "$told.* morph targets: the mesh is seen and felt" \
  "$told.* skins: the mesh is seen and felt" "$told.* animations: all is seen and felt at rest" -- check

# A picture that is not there, outside the folder, or a link out of it.
touch secret.png
ln -s ../secret.png looks/link.png
for why in 'none.png .No such file or directory' '../secret.png .it leads out of the folder' 'link.png .it leads out of the folder'; do
  picture=${why%% *}
  part ',"normalTexture":{"index":0}' "\"images\":[{\"uri\":\"$picture\"}],\"textures\":[{\"source\":0}]," '' '' ''
  expect 0 "$told the texture $picture, which cannot be read ${why#* }.*: export the model as .glb" check
done

# Light spreads below no metal.
spread() {
  part ",\"pbrMetallicRoughness\":{\"metallicFactor\":$1}" '' '' '' ''
  { cat looks/scenario.yaml && echo "materials: {shell: {scatter_distance: 0.001}}"; } >looks/spread.yaml
}
spread 0.5
check spread.yaml | grep 'does nothing' && fail "what light spreads below is told of as if it were not"
expect 0 'the light that enters surfaces, and spreads' "$FULCRUM" explain looks/spread.yaml
spread 1
expect 0 "'scatter_distance' does nothing where the material 'shell' is metal" check spread.yaml
expect 0 'no material that is lit, no metal and not seen through says how far light spreads below it' "$FULCRUM" explain looks/spread.yaml
exit $((failures > 0))
