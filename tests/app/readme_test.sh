#!/usr/bin/env bash
# readme_test.sh README [long]: every command in README's blocks works as it stands there, in a cheap form where it would
# open a window or take minutes; `long` runs those in full. A line that nothing here knows fails. $FULCRUM, $FULCRUM_CONTENT.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
readme=$(readlink -f "$1")
long=${2-}
top=$(dirname "$readme")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
fulcrum() { "$FULCRUM" "$@"; }
export -f fulcrum
export XDG_DATA_HOME=$work/data # nobody else's results
seen=0

# Two columns: the command ends where two spaces follow it.
while IFS= read -r line; do
  command=${line#    }
  case $command in
    python3*) ;;
    *) command=${command%%  *} ;;
  esac
  seen=$((seen + 1))
  read -r -a word <<<"$command"
  case $command in
    "tools/run" | "tools/test" | "tools/bench contact" | "tools/bench parts" | "tools/bench window" | "tools/bench latency")
      [ -x "$top/${word[0]}" ] || fail "$command: there is no such program" ;; # tests/tools, bench.*Long and app.*BenchLong run them
    "fulcrum run "*--headless*) expect 0 'Completed' "${word[@]}" ;;
    "fulcrum run "*) expect 3 'Not completed' "${word[@]}" --headless --seconds 0.1 --out "run_$seen" ;;
    "fulcrum check FILE") expect 0 'good' fulcrum check "$FULCRUM_CONTENT/scenarios/piping/scenario.yaml" ;;
    "fulcrum new "*) expect 0 'is made' "${word[@]}" ;;
    "fulcrum edit "*) # app.edit works it in a window
      expect 1 'display' env -u DISPLAY -u WAYLAND_DISPLAY "$FULCRUM" edit "${word[2]}" ;;
    "fulcrum import part.stl")
      printf 'solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 0\nendloop\nendfacet\nendsolid\n' >part.stl
      expect 0 'part.stl -> part.glb' "${word[@]}" ;;
    "fulcrum strip PRESSES.csv")
      printf '0.03,120\n0.1,4910\n0.17,9700\n' >PRESSES.csv
      expect 0 'low_ohm' "${word[@]}" ;;
    "fulcrum workprecision picture" | "fulcrum workprecision speed") # app.picture runs them on one scene
      if [ -n "$long" ]; then
        expect 0 'mean FLIP|level 4' "${word[@]}" --out "report_${word[2]}"
      else
        expect 0 'OPTIONS|Options' "${word[@]}" --help
      fi ;;
    "fulcrum compare "* | "fulcrum hardness "* | "fulcrum uniformity" | "fulcrum stability" | "fulcrum workprecision" | "fulcrum ambiguity "*)
      if [ -n "$long" ]; then
        expect 0 '.' "${word[@]}" --out "report_${word[1]}"
      else # app.compare, app.hardness and app.uniformity run them with fewer trials
        expect 0 'Usage|OPTIONS|Options' "${word[@]}" --help
      fi ;;
    "fulcrum") # app.start works it in a window
      expect 2 'Subcommands' env -u DISPLAY -u WAYLAND_DISPLAY "$FULCRUM" ;;
    "fulcrum list" | "fulcrum results" | "fulcrum replay "* | "fulcrum path "* | "fulcrum explain "* | "fulcrum devices" | "fulcrum device-test "*" --yes" | "fulcrum doctor" | "fulcrum schema") expect 0 '.' "${word[@]}" ;;
    python3*) command -v python3 >/dev/null && expect 0 '^[0-9.e-]+$' bash -c "$command" ;;
    *) fail "README names '$command', and tests/app/readme_test.sh does not know what it is to do" ;;
  esac
done < <(sed '/^```/,/^```/d' "$readme" | grep -E '^    [a-z]')
[ "$seen" -ge 20 ] || fail "only $seen commands were found in $readme"

# Commands within sentences are commands of the program.
for named in $(grep -oE '`(fulcrum|tools/bench) [a-z][a-z-]*' "$readme" | sed 's/.* //' | sort -u); do
  [ "$named" = contact ] || [ "$named" = parts ] || [ "$named" = window ] || expect 0 '.' fulcrum "$named" --help
done

[ $failures = 0 ] && echo "all good: $seen commands"
exit $((failures > 0))
