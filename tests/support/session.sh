# A session of somebody who trains, after start_page.sh. $PERSON is the pointer that sees only the window's pixels.

fewest=8 # pictures a second, for a person
is_complete() { grep -q '"completion_time_s": *[0-9]' "$(newest "$1")/summary.json" 2>/dev/null; }

# practise SCENE [PAD]: in the window, until it is complete, by mouse or by that pad. Ends the test where the machine is too
# slow for a person.
practise() {
  "$PERSON" "$1" "$window" ${2+"$2"} | tee "$work/practised"
  [ "${PIPESTATUS[0]}" != 0 ] || return 0
  if grep -oP '^[0-9.]+(?= pictures a second)' "$work/practised" | awk -v fewest=$fewest '{ exit !($1 < fewest) }'; then
    echo "skipped: too slow a machine, a person needs $fewest pictures a second"
    exit 77
  fi
  fail "$1 could not be carried out"
}
