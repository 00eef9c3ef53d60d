# For tests of a scenario's hands: runs them, and looks at what they leave in $box/HAND. $FULCRUM is the program, $SCENARIO
# the scenario's folder.
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

deepest=1e-4     # m, that a tool may go into the scene
least_port=-1e-4 # J, that the passivity observer may read: below nothing, the loop has given out energy
ran=

# SCENARIO HAND CODE FORCE_N: it ends with the code, goes nowhere deeper than $deepest, is pushed by no more than the force,
# and is given no energy: at the port, nothing below $least_port.
run_hand() {
  local code=0 depth force
  "$FULCRUM" run "$1" --headless --hand "$2" --size 64x36 --out "$box/$2" >"$box/log" 2>&1 || code=$?
  [ "$code" = "$3" ] || { cat "$box/log"; fail "$2 ended with $code"; }
  depth=$(figure "$box/$2/summary.json" max_penetration_m)
  force=$(figure "$box/$2/summary.json" peak_force_rendered_N)
  echo "$2: $depth m deep, at most $force N"
  awk -v d="$depth" -v f="$force" -v most="$4" -v deepest="$deepest" 'BEGIN { exit !(d != "" && d <= deepest && f > 0 && f <= most) }' ||
    fail "$2 goes too deep or pushes too hard"
  awk -F, -v hand="$2" -v bound="$least_port" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "energy/port") port = i; next }
    $port < least { least = $port }
    END {
      print hand ": " NR - 1 " ticks, least energy at the port " least + 0 " J"
      if (!port || NR < 1000 || least < bound) { print "FAILED: the port gives out energy, or the run is none"; exit 1 }
    }' "$box/$2/trace.csv"
  ran+="$2 "
}

# The last line of a test: no hand of the scenario was forgotten.
all_hands_ran() {
  local hand
  # The names under `hands:`, up to the next key that is not indented.
  for hand in $(sed -n '/^hands:/,/^[^ ]/s/^  \([a-z_]*\):.*/\1/p' "$SCENARIO/scenario.yaml"); do
    [[ " $ran" == *" $hand "* ]] || fail "the hand '$hand' was not run"
  done
  [ -n "$ran" ] || fail "no hand was run"
  echo "all good"
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
