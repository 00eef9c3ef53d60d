#!/usr/bin/env bash
# The expert completes the task, the clumsy hand does not, and neither gets more than 0.1 mm into what it touches.
set -euo pipefail
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT
run() { # HAND CODE
  local code=0
  "$FULCRUM" run teeth --headless --hand "$1" --out "$box/$1" >"$box/log" 2>&1 || code=$?
  [ "$code" = "$2" ] || { echo "FAILED: $1 ended with $code"; cat "$box/log"; exit 1; }
  sed -nE 's/.*"max_penetration_m": ([0-9.e-]+).*/\1/p' "$box/$1/summary.json" | awk -v hand="$1" '
    { n = 1; print hand ": " $1 * 1000 " mm"; if ($1 > 1e-4) { print "FAILED: that is too deep"; exit 1 } }
    END { if (!n) { print "FAILED: no penetration in the summary"; exit 1 } }'
}
run expert 0
run clumsy 3
echo "all good"
