# A session of somebody who trains, after display.sh. $PERSON is the pointer that sees only the window's pixels.

# too_slow: the pointer was shown fewer pictures a second than it can work with (it does the teeth at 3 to 5). One that moved
# nothing tells 0, and one that fell over tells nothing: neither says that the machine is slow.
fewest=3
too_slow() {
  grep -oP '^[0-9.]+(?= pictures a second)' "$work/practised" |
    awk -v fewest=$fewest '$1 > 0 && $1 < fewest { slow = 1 } END { exit !slow }'
}
skip_too_slow() {
  echo "skipped: too slow a machine, the pointer needs $fewest pictures a second"
  exit 77
}

# practise SCENE [PAD]: in the window, until it is complete, by mouse or by that pad. Ends the test where the machine is too
# slow for that.
practise() {
  "$PERSON" "$1" "$window" ${2+"$2"} | tee "$work/practised"
  [ "${PIPESTATUS[0]}" != 0 ] || return 0
  ! too_slow || skip_too_slow
  fail "$1 could not be carried out"
}

# is_complete SCENE: its newest run, after start_page.sh.
is_complete() { grep -q '"completion_time_s": *[0-9]' "$(newest "$1")/summary.json" 2>/dev/null; }
