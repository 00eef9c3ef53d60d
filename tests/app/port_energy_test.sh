#!/usr/bin/env bash
# Every shipped scenario in every hand it has: at the port the loop gives out no more than a tenth of a millijoule.
# Teeth's clumsy hand trembles on the border of a count, where the observer reads far below the truth:
# port_energy_test.cpp holds it to the truth itself.
set -euo pipefail
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT
runs=0
for file in "$FULCRUM_CONTENT"/scenarios/*/scenario.yaml; do
  # The names under `hands:`, up to the next key that is not indented.
  for hand in $(sed -n '/^hands:/,/^[^ ]/s/^  \([a-z_]*\):.*/\1/p' "$file"); do
    [ "$(basename "$(dirname "$file")") $hand" != "teeth clumsy" ] || continue
    code=0
    "$FULCRUM" run "$file" --headless --hand "$hand" --size 64x36 --out "$box/run" --force >"$box/log" 2>&1 || code=$?
    [ "$code" = 0 ] || [ "$code" = 3 ] || { echo "FAILED: $file in hand $hand ended with $code"; cat "$box/log"; exit 1; }
    awk -F, -v who="$(basename "$(dirname "$file")") $hand" '
      NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "energy/port") port = i; next }
      $port < least { least = $port }
      END {
        print who ": " NR - 1 " ticks, least energy at the port " least + 0 " J"
        if (!port || NR < 1000 || least < -1e-4) { print "FAILED"; exit 1 }
      }' "$box/run/trace.csv"
    runs=$((runs + 1))
  done
done
[ "$runs" -ge 14 ] || { echo "FAILED: only $runs runs"; exit 1; }
echo "all good"
