# What the tests of a headset share, sourced by them: the runtime of the tests' own (tests/xr/runtime/script.h), under Debian's
# validation layer of OpenXR where it is installed. $FULCRUM is the program, $RUNTIME the manifest. What is waited for is seen,
# never timed.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
program=
trap '[ -z "$program" ] || kill -9 $program 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1
limit=${FULCRUM_TEST_LIMIT:-300} # s, ends what hangs, and decides nothing else
export XR_RUNTIME_JSON=$RUNTIME FULCRUM_XR_SCRIPT=$work/script FULCRUM_XR_LOG=$work/log XDG_CONFIG_HOME=$work/config
unset DISPLAY WAYLAND_DISPLAY
mkdir -p config/fulcrum && echo '{"picture": "lowest"}' >config/fulcrum/settings.json

. "$(dirname "$(readlink -f "$0")")/layer.sh"

# goes_well: neither the runtime nor the layers had anything to say of what was just run, and its end was in order.
goes_well() {
  ! grep -m 5 '^WRONG' log || fail "$1: the runtime was called wrongly"
  [ ! -s messages ] || fail "$1: the validation layer says: $(head -5 messages)"
  [ -z "${XR_ENABLE_API_LAYERS-}" ] || grep -q 'Core Validation output' said || fail "$1: the validation layer was not there"
  grep -q '^xrDestroyInstance' log || fail "$1: the instance is not destroyed"
  rm -f messages
}

run() { # ARGS of fulcrum run --xr; $code, and what it says in ./said
  timeout "$limit" "$FULCRUM" run --xr --mute "$@" >said 2>&1
  code=$?
}

# column FOLDER NAME: its values, of whole rows: the last one may still be written.
column() { awk -F, -v name="$2" 'NR == 1 { n = NF; for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } NF == n { print $c }' "$1/trace.csv"; }

# start ARGS: the same, and goes on; until_seen COMMAND...: waits for it to succeed; 1 if it never does, or if the run ends.
start() {
  rm -f log
  "$FULCRUM" run --xr --mute "$@" >said 2>&1 &
  program=$!
}
until_seen() {
  local end=$((SECONDS + limit)) runs=1
  while ! "$@" 2>/dev/null; do
    [ $runs = 1 ] && [ $SECONDS -lt $end ] || return 1
    kill -0 $program 2>/dev/null || runs=0
    sleep 0.1
  done
}
wait_for_end() {
  gone() { ! kill -0 $program 2>/dev/null; }
  until_seen gone || { fail "it does not end: $(cat said)"; kill -9 $program; }
  wait $program
  code=$?
  program=
}

# Of the run in A: how often the force has been stopped, and whether it is. stopped N: so often; back N: and has gone on after.
stops() { column A fault | awk '{ now = $1 % 65536 > 0; n += now && !was; was = now } END { print n + 0, was + 0 }'; }
stopped() { [ -f A/trace.csv ] && [ "$(stops)" = "$1 1" ]; }
back() { [ -f A/trace.csv ] && [ "$(stops)" = "$1 0" ]; }

# Of the run in A: the newest tick's fault has that bit, or one that stops.
has_fault() { [ -f A/trace.csv ] && column A fault | tail -1 | awk -v bit="$1" '{ exit !(int($1 / bit) % 2) }'; }
has_no_fault() { [ -f A/trace.csv ] && column A fault | tail -1 | awk '{ exit $1 % 65536 != 0 }'; }
stop_requested=1 not_finite=2 sample_stale=4 unanswered=64

# later N: from now on N ticks have passed, as far as the run in A has written.
later() {
  local rows
  rows=$(wc -l <A/trace.csv)
  gone_by() { [ "$(wc -l <A/trace.csv)" -gt $((rows + $1)) ]; }
  until_seen gone_by "$1" || fail "no ticks come: $(cat said)"
}

# went X Z: in the run in A the handle has moved so far, m, within 10 um, and not in height. in_world X Z: a way in the room,
# for who looks as piping's first view does, whose heading is atan2(0.4, 0.92).
went() {
  [ -f A/trace.csv ] && paste -d' ' <(column A handle/p/x) <(column A handle/p/y) <(column A handle/p/z) |
    awk -v x="$1" -v z="$2" 'NR == 1 { x0 = $1; y0 = $2; z0 = $3 } NF == 3 { a = $1; b = $2; c = $3 }
      function near(p, q) { return (p - q) ^ 2 < 1e-10 } END { exit !(near(a - x0, x) && near(b, y0) && near(c - z0, z)) }'
}
in_world() { awk -v x="$1" -v z="$2" 'BEGIN { l = sqrt(0.4 ^ 2 + 0.92 ^ 2); c = 0.92 / l; s = 0.4 / l; print c * x + s * z, -s * x + c * z }'; }
