#!/usr/bin/env bash
# latency_bench.sh [SCENARIO...]: how old the tool is by the time it is seen, in a window on a display without a screen, at
# the lowest and at the third quality level and two sizes, while each scenario's expert moves it for 12 s by the clock. Ms,
# median and what 99 % of the pictures do not exceed. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/display.sh"
. "$(dirname "$(readlink -f "$0")")/../support/hand_to_pixel.sh"
seconds=12
start_display 1920x1080
[ $# -gt 0 ] || set -- tutorial piping teeth ear plate knock stick sweep nut
export XDG_CONFIG_HOME=$work/config
mkdir -p "$work/config/fulcrum"

# Its time is over, or its task, after which the window stays.
done_with() { more_rows "$1" $((seconds * 1000 - 1)) || [ -s "$1/summary.json" ]; }
figure() { sed -n "s/.*\"$2\": \([0-9.]*\).*/\1/p" "$1/summary.json" | cut -c 1-5; }

printf '%-10s %-8s %-10s %8s %13s %13s %13s %13s %13s\n' scenario level size frames/s tick wait draw show whole
for scene in "$@"; do
  for level in lowest medium; do
    echo "{\"picture\": \"$level\"}" >"$work/config/fulcrum/settings.json"
    for size in 640x360 1280x720; do
      out=$work/$scene-$level-$size
      open_window "$scene" --device simulated --hand expert --size $size --seconds $seconds --out "$out"
      until_seen done_with "$out"
      kill -INT "$program"
      wait_for_end
      printf '%-10s %-8s %-10s %8s%s\n' "$scene" $level $size "$(figure "$out" frames_per_s)" "$(stages_of "$out" | awk '{ printf " %13s", sprintf("%.1f / %.1f", $2, $3) }')"
    done
  done
done
[ $failures = 0 ]
