#!/usr/bin/env bash
# window_bench.sh [SCENARIO...]: what a window costs the haptic thread, and how many frames it draws. Each scenario's expert
# moves the tool for 12 s by the clock, in a window of 640x360 on a display without a screen and without one, in turn, twice.
# $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
seconds=12
start_display
[ $# -gt 0 ] || set -- piping plate stick

# timing_column FOLDER NAME
timing_column() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } { print $c }' "$1/timing.csv"; }
# of_ticks FOLDER: ticks whose own processor time is above a millisecond, and the largest in us.
of_ticks() { timing_column "$1" cpu_us | awk '$1 > 1e3 { ++above } $1 > most { most = $1 } END { printf "%d %.0f\n", above, most }'; }
figure() { sed -n "s/.*\"$2\": \([0-9.]*\).*/\1/p" "$1/summary.json"; }

row() { # SCENARIO HOW FOLDER
  local above most
  read -r above most < <(of_ticks "$3")
  printf '%-10s %-12s %8s %12s %6s %13s %12s\n' "$1" "$2" "$(figure "$3" frames_per_s | cut -c 1-5)" \
    "$(figure "$3" late_ticks)" "$(figure "$3" lost_ticks)" "$above" "$most"
}

printf '%-10s %-12s %8s %12s %6s %13s %12s\n' scenario "" "frames/s" "late ticks" "lost" "above period" "largest us"
for scene in "$@"; do
  for turn in 1 2; do
    open_window "$scene" --device simulated --hand expert --size 640x360 --seconds $seconds --out "$work/$scene-window-$turn"
    until_seen more_rows "$work/$scene-window-$turn" $((seconds * 1000 - 1))
    kill -INT "$program"
    wait_for_end
    row "$scene" window "$work/$scene-window-$turn"
    "$FULCRUM" run "$scene" --headless --realtime --hand expert --seconds $seconds --out "$work/$scene-alone-$turn" >"$work/said" 2>&1
    row "$scene" "no window" "$work/$scene-alone-$turn"
  done
done
[ $failures = 0 ]
