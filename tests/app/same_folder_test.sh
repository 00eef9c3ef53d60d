#!/usr/bin/env bash
# Two programs that are told the same folder: the first has it until it ends, however it does, and the second removes nothing
# of it. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
program=
trap '[ -z "$program" ] || kill -9 $program 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1
limit=${FULCRUM_TEST_LIMIT:-300} # s, ends what hangs, and decides nothing else
run=("$FULCRUM" run piping --headless --overlay none --size 64x36 --out A --force)

start() { # and waits until it writes
  "${run[@]}" --realtime --seed 11 --set time_limit=3600 >said 2>&1 &
  program=$!
  local end=$((SECONDS + limit))
  while [ "$(cat A/trace.csv 2>/dev/null | wc -l)" -lt 100 ] && kill -0 $program 2>/dev/null && [ $SECONDS -lt $end ]; do sleep 0.1; done
  kill -0 $program 2>/dev/null || fail "it does not run: $(cat said)"
}
ends() { # SIGNAL
  kill "-$1" $program
  wait $program 2>/dev/null
  code=$?
  program=
}

start
refused='^fulcrum: another run is writing into A: wait for its end, or choose another folder with --out\.$'
expect 1 "$refused" "${run[@]}" --seconds 0.01 --seed 22
expect 1 "$refused" "$FULCRUM" ambiguity piping --out A --force
expect 1 "$refused" "$FULCRUM" replay A/tape --out A --force
ends INT
[ $code = 3 ] || fail "exit $code of the first: $(cat said)"
sum=$(sha256sum <A/trace.csv)
grep -q "\"trace_sha256\": \"${sum%% *}\"" A/summary.json || fail "trace and summary are of two runs"
grep -q '"seed": 11' A/summary.json || fail "the first run's summary is gone"

# Whoever is killed has nothing any more.
start
ends KILL
expect 3 'Not completed' "${run[@]}" --seconds 0.01 --seed 22
grep -q '"seed": 22' A/summary.json || fail "what a killed run left is not replaced"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
