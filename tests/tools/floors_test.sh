#!/usr/bin/env bash
# floors_test.sh [ROOT]: the folders of the haptic core stand on floors, the lowest first, and a folder includes only
# from floors below its own. CMake cannot say so: they are one room.
set -euo pipefail
root=${1:-$(dirname "$(readlink -f "$0")")/../..}
floors=(
  "math"
  "signal geometry tool"
  "bake contact device"
  "actuation estimate tick"
  "safety scene"
  "effects motion"
  "world"
  "loop"
)
declare -A floor
for i in "${!floors[@]}"; do
  for folder in ${floors[i]}; do floor[$folder]=$i; done
done

wrong=0 arrows=0
for folder in "$root"/haptics/*/; do
  name=$(basename "$folder")
  [ -n "${floor[$name]-}" ] || { echo "FAILED: haptics/$name stands on no floor: give it one in $0"; wrong=1; continue; }
  while IFS=: read -r file line include; do
    below=$(sed -n 's#.*"haptics/\([a-z_]*\)/.*#\1#p' <<<"$include")
    [ "$below" != "$name" ] || continue
    arrows=$((arrows + 1))
    [ -n "${floor[$below]-}" ] && [ "${floor[$below]}" -lt "${floor[$name]}" ] && continue
    echo "FAILED: ${file#"$root"/}:$line includes from haptics/$below, which is not below haptics/$name"
    wrong=1
  done < <(grep -rn '#include "haptics/' "$folder")
done
[ "$arrows" -gt 100 ] || { echo "FAILED: only $arrows includes between folders were seen"; exit 1; }
[ "$wrong" = 0 ] || exit 1
echo "all good: $arrows includes, each from a floor below"
