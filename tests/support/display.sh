# A display without a screen, and Fulcrum in a window on it. $FULCRUM is the program. What is waited for is seen, never
# timed: the limits only end a test that hangs.
for command in Xvfb openbox xdotool import identify; do command -v $command >/dev/null || { echo "skipped: no $command"; exit 77; }; done
work=$(mktemp -d)
limit=${FULCRUM_TEST_LIMIT:-300} # s, ten times what a busy machine needs for any one wait
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# until COMMAND...: waits for it to succeed; 1 if it never does.
until_seen() {
  local end=$((SECONDS + limit))
  while ! "$@"; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.1
  done
}

start_display() { # [SIZE]
  local pipe number
  exec {pipe}<> <(:)
  # Without -noreset the server starts anew when its last client leaves, and refuses a client that connects just then.
  Xvfb -noreset -displayfd $pipe -screen 0 "${1:-1280x800}x24" >/dev/null 2>&1 &
  xvfb=$!
  read -r -u $pipe number || exit 1
  exec {pipe}>&-
  export DISPLAY=:$number
  openbox >/dev/null 2>&1 &
  # Only a window manager knows of desktops; a window that is there before it would be taken over while it is used.
  until_seen xdotool get_num_desktops >/dev/null 2>&1 || exit 1
}

trap 'kill $xvfb 2>/dev/null; [ -z "${program-}" ] || kill -9 $program 2>/dev/null; rm -rf "$work"' EXIT

# Without --all, the window of a program that has just ended is one as well, for as long as the display has it.
find_window() {
  window=$(xdotool search --all --onlyvisible --pid $program --name '^Fulcrum' 2>/dev/null | head -n 1)
  [ -n "$window" ] || ! kill -0 $program 2>/dev/null
}

# open_window ARGS of fulcrum run...: sets $program and $window; what it says is in $work/said.
open_window() {
  "$FULCRUM" run "$@" >"$work/said" 2>&1 &
  program=$!
  window=
  until_seen find_window
  [ -n "$window" ] || { cat "$work/said"; echo "FAILED: no window"; exit 1; }
}

# ended: the program has. Sets $code.
gone() { ! kill -0 $program 2>/dev/null; }
wait_for_end() {
  until_seen gone || { fail "the window did not close: $(cat "$work/said")"; kill -9 $program; }
  wait $program
  code=$?
  program=
}

# shot NAME [CROP]: what the window shows, as $work/NAME.png. A program that ended by itself ends the test, with what it
# said. Where `import` finds no such window, it waits until somebody clicks one; nobody does.
shot() {
  if gone; then
    wait $program
    echo "FAILED: the program ended by itself with $?: $(cat "$work/said")" >&2
    exit 1
  fi
  timeout "$limit" import -window "$window" ${2:+-crop "$2" +repage} "$work/$1.png"
}

# rows FOLDER: ticks that its trace holds.
rows() { [ -f "$1/trace.csv" ] && echo $(($(wc -l <"$1/trace.csv") - 1)) || echo 0; }
more_rows() { [ "$(rows "$1")" -gt "$2" ]; }
# runs FOLDER [N]: its run has written N more ticks than it had; a run that ended never does.
runs() {
  local had
  had=$(rows "$1")
  until_seen more_rows "$1" $((had + ${2:-500}))
}

# column FOLDER NAME: its values.
column() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } NF >= c { print $c }' "$1/trace.csv"; }
