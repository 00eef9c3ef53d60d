# What a run's summary says of how old the tool was when it was seen.

# stages_of FOLDER: a line for each stage: its name, median, what 99 % of the pictures do not exceed, longest; ms.
stages_of() {
  awk -F'[:,]' '/"hand_to_pixel_ms"/ { inside = 1 }
    inside && /"(tick|wait|draw|show|whole)"/ { split($1, name, "\""); printf "%s", name[2] }
    inside && /"(p50|p99)"/ { printf " %s", $2 + 0 }
    inside && /"max"/ { printf " %s\n", $2 + 0 }' "$1/summary.json" | head -n 5
}

# has_hand_to_pixel FOLDER N: it is there, of so many pictures at least; every stage takes its time, and none more than the
# whole.
has_hand_to_pixel() {
  awk -F'[:,]' -v least="$2" '/"hand_to_pixel_ms"/ { inside = 1 } inside && /"frames"/ { found = $2 >= least; exit } END { exit !found }' "$1/summary.json" &&
    stages_of "$1" | awk '{ name = name $1 " "; if ($2 < 0 || $2 > $3 || $3 > $4) wrong = 1; if ($1 == "draw") draw = $4; whole = $4 }
      END { exit wrong || name != "tick wait draw show whole " || draw <= 0 || whole < draw }'
}
