# For tests of a scenario's hands: runs them, and looks at what they leave in $box/HAND.
set -euo pipefail
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT

fail() {
  echo "FAILED: $*"
  exit 1
}

figure() { # FILE KEY: a number of a summary
  sed -nE "s/.*\"$2\": ([0-9.e-]+).*/\1/p" "$1"
}

deepest=1e-4 # m, that a tool may go into the scene

# SCENARIO HAND CODE FORCE_N: it ends with the code, goes nowhere deeper than $deepest, and is pushed by no more than that.
run_hand() {
  local code=0 depth force
  "$FULCRUM" run "$1" --headless --hand "$2" --size 64x36 --out "$box/$2" >"$box/log" 2>&1 || code=$?
  [ "$code" = "$3" ] || { cat "$box/log"; fail "$2 ended with $code"; }
  depth=$(figure "$box/$2/summary.json" max_penetration_m)
  force=$(figure "$box/$2/summary.json" peak_force_rendered_N)
  echo "$2: $depth m deep, at most $force N"
  awk -v d="$depth" -v f="$force" -v most="$4" -v deepest="$deepest" 'BEGIN { exit !(d != "" && d <= deepest && f > 0 && f <= most) }' ||
    fail "$2 goes too deep or pushes too hard"
}

# HAND: a line for each time the tool meets the scene: when (s), how fast (m/s) it came, with how many regions, and with
# how many at most within the next 20 ms.
touches() {
  awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    { t = $at["timestamp"]; n = $at["contact/regions"] }
    n > 0 && before == 0 { if (met) print met, most; met = t " " speed " " n; since = t; most = n }
    met && t - since <= 0.02 && n > most { most = n }
    { before = n; vx = $at["tool/v/x"]; vy = $at["tool/v/y"]; vz = $at["tool/v/z"]; speed = sqrt(vx * vx + vy * vy + vz * vz) }
    END { if (met) print met, most }
  ' "$box/$1/trace.csv"
}
