#!/usr/bin/env bash
# The expert's way and the checkpoints in the scenario are those that the models' program writes: within 0.1 mm, since
# another compiler may round otherwise. $MAKE is that program, $SCENARIO the scenario's folder.
set -euo pipefail
words() { # a word or a number a line
  grep -v '^ *#' | tr -s ' ,{}[]:-' '\n' | grep .
}
signed() { # keeps the sign of numbers
  sed 's/-\([0-9]\)/ m\1/g' | words | sed 's/^m/-/'
}
alike() { # WHAT GOT WANTED
  diff <(wc -l <<<"$2") <(wc -l <<<"$3") >/dev/null || { echo "FAILED: $1 has other entries"; exit 1; }
  paste <(printf '%s\n' "$2") <(printf '%s\n' "$3") | awk -v what="$1" '
    { d = $1 - $2; if ($1 ~ /^-?[0-9.]+$/ ? (d > 1e-4 || d < -1e-4) : $1 != $2) {
        print "FAILED: " what " says " $2 " where the program says " $1; exit 1 } }'
}
alike expert.yaml "$("$MAKE" --route | signed)" "$(signed <"$SCENARIO/expert.yaml")"
checkpoints=$(sed -n '/^checkpoints:/,/^[a-z]*:$/p' "$SCENARIO/scenario.yaml" | grep '^  - {name' | signed)
alike "the list of checkpoints" "$("$MAKE" --checkpoints | signed)" "$checkpoints"
echo "all good"
