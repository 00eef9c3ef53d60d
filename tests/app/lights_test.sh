#!/usr/bin/env bash
# A model whose file brings lights: they are drawn, explained and told of; without one nothing is built; a file that cannot
# be meant, or brings too many, is told of where the scenario names it. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

"$FULCRUM" new plain >/dev/null || fail "no scenario could be made"
expect 0 'lights of models .*no model brings one' "$FULCRUM" explain plain/scenario.yaml

# A tetrahedron of 2 cm and $2 nodes, each with the light $1.
lamp() {
  local nodes='{"mesh":0}' roots=0 i
  for ((i = 1; i <= $2; ++i)); do
    nodes+=',{"translation":[0,0.2,0.1],"extensions":{"KHR_lights_punctual":{"light":0}}}'
    roots+=",$i"
  done
  cat <<GLTF
{"asset":{"version":"2.0"},"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[$1]}},
"scene":0,"scenes":[{"nodes":[$roots]}],"nodes":[$nodes],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[0.02,0.02,0.02]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAACtejPAAAAAAAAAAAAAAAAArXozwAAAAAAAAAAAAAAAAK16M8AAACAAEAAAABAAMAAAADAAIAAQACAAMA"}]}
GLTF
}
drawn() { "$FULCRUM" run lit/scenario.yaml --headless --seconds 0.01 --size 64x36 --overlay none --out "$1"; }
cp -r plain lit
sed -i 's/^models:$/&\n  lamp: {file: lamp.gltf, role: decor, position: [0.05, 0, 0]}/' lit/scenario.yaml
line=$(grep -n 'lamp.gltf' lit/scenario.yaml | cut -d: -f1)
lamp '{"type":"point","intensity":0}' 1 >lit/lamp.gltf
expect 3 'Picture, trace' drawn dark
lamp '{"type":"point","intensity":60}' 1 >lit/lamp.gltf
expect 0 "scenario.yaml:$line:[0-9]+: .*'lamp.gltf' brings a light .KHR_lights_punctual., which throws no shadow: .*" "$FULCRUM" check lit/scenario.yaml
expect_each 0 'lights of models .*1, in those of surfaces: without shadows' -- "$FULCRUM" explain lit/scenario.yaml
expect 3 'Picture, trace' drawn bright
cmp -s dark/frame.png bright/frame.png && fail "a light changes nothing in the picture"

lamp '{"type":"point"}' 9 >lit/lamp.gltf
expect 1 "scenario.yaml:$line:[0-9]+: model 'lamp': 'lamp.gltf' brings 9 lights .*at most 8 are drawn" "$FULCRUM" check lit/scenario.yaml
lamp '{"type":"spot","spot":{"innerConeAngle":1,"outerConeAngle":0.5}}' 1 >lit/lamp.gltf
expect 1 "scenario.yaml:$line:[0-9]+: model 'lamp': .*lamp.gltf: its light '0' has an inner cone .*wider than the outer" "$FULCRUM" check lit/scenario.yaml
exit $((failures > 0))
