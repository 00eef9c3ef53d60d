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
lamp '{"type":"point","intensity":3e8}' 1 >lit/lamp.gltf
sed 's/lamp.gltf,/& scale: 100,/' lit/scenario.yaml >lit/scaled.yaml
expect 1 "scaled.yaml:$line:[0-9]+: model 'lamp': 'lamp.gltf' brings a light '0' of more than a billion candela, .*'scale' are counted in" \
  "$FULCRUM" check lit/scaled.yaml
# A lamp of 60 cd in a file of millimetres, which is brighter than any in one of metres.
lamp '{"type":"point","intensity":6e10,"range":1e6}' 1 >lit/lamp.gltf
sed 's/lamp.gltf,/& unit: mm,/' lit/scenario.yaml >lit/millimetres.yaml
expect 1 "scenario.yaml:$line:[0-9]+: model 'lamp': 'lamp.gltf' brings a light '0' of more than a billion candela" "$FULCRUM" check lit/scenario.yaml
expect_each 0 "millimetres.yaml: good" "'lamp.gltf' brings a light" -- "$FULCRUM" check lit/millimetres.yaml

# What is not drawn is named.
lamp '{"type":"point","intensity":60}' 1 | sed 's/"extensionsUsed":\[/&"KHR_materials_iridescence",/' >lit/lamp.gltf
expect 0 "scenario.yaml:$line:[0-9]+: .*'lamp.gltf' is drawn without KHR_materials_iridescence" "$FULCRUM" check lit/scenario.yaml

# What a terminal would obey is not told it.
lamp '{"name":"\u001b[31mred\u001b]0;title\u0007","type":"point","intensity":-1}' 1 >lit/lamp.gltf
expect 1 "its light '.*red.*' has a value of 'intensity' that is less than zero" "$FULCRUM" check lit/scenario.yaml
"$FULCRUM" check lit/scenario.yaml | grep -q $'[\x07\x1b]' && fail "what a light is called reaches the terminal as it is"

# Of marked objects, a light goes with those that are marked as it is.
lamp '{"name":"bulb","type":"point","intensity":60}' 1 | sed 's/"nodes":\[{"mesh":0}/"nodes":[{"mesh":0,"extras":{"fulcrum_role":"decor"}}/' >lit/lamp.gltf
sed 's/lamp.gltf,/& marked: true,/' lit/scenario.yaml >lit/marked.yaml
expect 0 "marked.yaml:$line:[0-9]+: model 'lamp': 'lamp.gltf' has a light 'bulb' that lights nothing, for no model takes it" \
  "$FULCRUM" check lit/marked.yaml
sed -i 's/"translation"/"extras":{"fulcrum_role":"decor"},&/' lit/lamp.gltf
"$FULCRUM" check lit/marked.yaml | grep 'lights nothing' && fail "a light that is taken is told of as left out"

# Of a model that another file is drawn for, that one has the lights.
lamp '{"name":"bulb","type":"point","intensity":60}' 1 >lit/lamp.gltf
lamp '{"name":"flash","type":"point","intensity":60}' 2 >lit/other.gltf
sed 's/lamp.gltf, role: decor,/lamp.gltf, drawn: other.gltf, role: scene,/' lit/scenario.yaml >lit/drawn.yaml
expect_each 0 "drawn.yaml:$line:[0-9]+: model 'lamp': 'lamp.gltf' has a light 'bulb' that lights nothing, since 'drawn' takes its place: put it into 'other.gltf'\." \
  "'other.gltf' brings 2 lights" -- "$FULCRUM" check lit/drawn.yaml
sed -i 's/flash/bulb/' lit/other.gltf
"$FULCRUM" check lit/drawn.yaml | grep 'lights nothing' && fail "a light that the drawn file has is told of as left out"

# An import takes none, and says so.
lamp '{"type":"point","intensity":60}' 2 >lit/lamp.gltf
expect 0 '2 lights are left out: a scenario that names a .glb or .gltf itself has its lights' "$FULCRUM" import lit/lamp.gltf --out imported
exit $((failures > 0))
