#!/usr/bin/env bash
# The expert's way in the scenario is the one that the models' program proves passable: every waypoint within 0.1 mm.
# The yielding hand's way is the one that the same program writes.
# $MAKE_PIPING is that program, $SCENARIO the scenario's folder.
set -euo pipefail
triples() { # KEY: the numbers of each "KEY: [x, y, z...]" line
  sed -nE "s/^ *-? *$1: \[([^]]*)\].*/\1/p" | tr ',' ' '
}
route=$("$MAKE_PIPING" --route)
for pair in p_WT:position q_WT:orientation; do
  paste <(triples "${pair%:*}" <<<"$route") <(triples "${pair#*:}" <"$SCENARIO/expert.yaml") |
    awk -v key="${pair#*:}" '
      { n = NF / 2; if (NF < 6 || n != int(n)) { print "FAILED: waypoint " NR " has no partner: " $0; exit 1 }
        for (i = 1; i <= n; ++i) { d = $i - $(i + n); if (d > 1e-4 || d < -1e-4) {
          print "FAILED: " key " of waypoint " NR " differs by " d; exit 1 } } }
      END { if (NR < 10) { print "FAILED: only " NR " waypoints"; exit 1 } }'
done
diff <("$MAKE_PIPING" --wrong-turns) "$SCENARIO/yielding.yaml" || {
  echo "FAILED: yielding.yaml is not what make_piping --wrong-turns writes"
  exit 1
}
echo "all good"
