#!/usr/bin/env bash
# package_test.sh SOURCE BUILD CMAKE: a project outside the tree finds an installed Fulcrum, builds examples/ against it, and
# they do what they say. $FULCRUM, $FULCRUM_CONTENT, $XDG_CACHE_HOME.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
source=$1 build=$2 cmake=$3
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT

quietly() { "$@" >"$box/log" 2>&1 || { fail "$*"; tail -30 "$box/log"; }; }
quietly "$cmake" --install "$build" --prefix "$box/prefix"
cp -r "$source/examples" "$box/examples" # nothing of the tree can be reached from there
quietly "$cmake" -G Ninja -S "$box/examples" -B "$box/build" -DCMAKE_PREFIX_PATH="$box/prefix"
quietly "$cmake" --build "$box/build"

# A program for a wider processor takes the core's types as they are, and its inline functions give the same bits.
if grep -qw avx2 /proc/cpuinfo && grep -qw fma /proc/cpuinfo; then
  quietly "$cmake" -G Ninja -S "$box/examples" -B "$box/wide" -DCMAKE_PREFIX_PATH="$box/prefix" -DCMAKE_CXX_FLAGS=-march=x86-64-v3
  quietly "$cmake" --build "$box/wide" --target hello
  quietly cmp <("$box/build/hello") <("$box/wide/hello")
fi

# The hand is 2 mm below the floor, and the tool stays on it.
expect 0 '^hand -2.00 mm, tool [+-]0.00[0-9] mm, force [0-9.]*[1-9][0-9.]* N$' "$box/build/hello"
expect 0 '^0.499,1.5,1.5$' "$box/build/own_effect"
expect 0 '^1.999,0,0$' "$box/build/own_effect"
"$FULCRUM" run piping --headless --seconds 0.2 --out "$box/run" >/dev/null 2>&1
expect 0 '^tool/p/x is largest at [0-9.]+ s: [0-9.e-]+$' "$box/build/read_trace" "$box/run/trace.csv" tool/p/x

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
