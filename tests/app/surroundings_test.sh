#!/usr/bin/env bash
# A scene that has its light from an .hdr: it is drawn and explained, and a file that cannot be used is told of where the
# scenario names it. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

"$FULCRUM" new plain >/dev/null || fail "no scenario could be made"
expect_each 0 'the studio as mirrors' 'picture of the surroundings.*the scene has its light from the studio' -- \
  "$FULCRUM" explain plain/scenario.yaml

# Two rows of four pixels: a blue sky, a dark ground.
hdr() {
  local sky='\100\140\377\201' ground='\040\030\020\200'
  printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n'
  # shellcheck disable=SC2059: octal digits of pixels
  printf "$sky$sky$sky$sky$ground$ground$ground$ground"
}
drawn() { "$FULCRUM" run lit/scenario.yaml --headless --seconds 0.01 --size 64x36 --overlay none --out "$1"; }
cp -r plain lit
hdr >lit/sky.hdr
sed -i '/^ambient:/d' lit/scenario.yaml
echo 'ambient: {kind: picture, file: sky.hdr, seen: true}' >>lit/scenario.yaml
line=$(grep -n '^ambient:' lit/scenario.yaml | cut -d: -f1)
expect 0 '' "$FULCRUM" check lit/scenario.yaml
expect_each 0 'a picture as mirrors of six roughnesses show it' 'background .*the surroundings' -- "$FULCRUM" explain lit/scenario.yaml
expect 3 'Picture, trace' drawn lit_run
[ -s lit_run/frame.png ] || fail "no picture was drawn"

head -c 60 lit/sky.hdr >lit/cut.hdr
sed -i 's/sky\.hdr/cut.hdr/' lit/scenario.yaml
expect 1 "scenario.yaml:$line:[0-9]+: 'cut.hdr' cannot be used: it is damaged .*export it again" "$FULCRUM" check lit/scenario.yaml
expect 3 "there is no picture: .*scenario.yaml:$line:[0-9]+: 'cut.hdr' cannot be used" drawn cut_run
sed -i 's/cut\.hdr/skj.hdr/' lit/scenario.yaml
expect 1 "scenario.yaml:$line:[0-9]+: cannot read 'skj.hdr': .*did you mean 'sky.hdr'" "$FULCRUM" check lit/scenario.yaml
sed -i 's/skj\.hdr/sky.hdr, sky: [1, 1, 1]/' lit/scenario.yaml
expect 1 "scenario.yaml:$line:[0-9]+: .*sky" "$FULCRUM" check lit/scenario.yaml
exit $((failures > 0))
