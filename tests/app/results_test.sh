#!/usr/bin/env bash
# Results of trials, from outside: kept for who was named, listed, exported, deleted without a trace. $FULCRUM is the
# program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted
export XDG_DATA_HOME=$work/data
runs=$work/data/fulcrum/runs store=$work/data/fulcrum/results.sqlite

# --- nobody yet; a run of nobody leaves a report, compared with nobody, and no row
expect 0 'There are no results yet' "$FULCRUM" results
expect 0 'There are no participants yet' "$FULCRUM" results --participants
expect 0 'report lie in' "$FULCRUM" run stick --headless --out nobody
grep -q 'There is no expert to compare with' nobody/report.html || fail "compared, though nobody was named"
[ "$("$FULCRUM" results --json)" = '[]' ] || fail "a run of nobody was kept"

# --- two trials of one, and one of another, ended early
expect 0 'score 100 of 100' "$FULCRUM" run stick --headless --participant P1
expect 3 'score [0-9]+ of 100' "$FULCRUM" run stick --headless --hand clumsy --participant P1
expect 3 'report lie in' "$FULCRUM" run stick --headless --hand still --seconds 1 --participant P2 --out "of p2's"
[ "$("$FULCRUM" results | grep -c stick)" = 3 ] || fail "not three trials: $("$FULCRUM" results)"
expect 0 'ended early' "$FULCRUM" results --participant P2
[ "$("$FULCRUM" results --participant P1 | grep -c stick)" = 2 ] || fail "the filter lets others through"
expect 1 "there is no participant 'P3'" "$FULCRUM" results --participant P3
expect 0 'There are no results of that scenario' "$FULCRUM" results --scenario ear
expect 0 'P1 +2 +no' "$FULCRUM" results --participants

# --- exports are new files
expect 0 'all.csv' "$FULCRUM" results --csv all.csv
[ "$(wc -l <all.csv)" = 4 ] || fail "the CSV has not a line for each trial"
head -n 1 all.csv | grep -q '^participant,session,trial,scenario,.*,time_s,.*,smoothness,.*,trace_sha256$' ||
  fail "the header is $(head -n 1 all.csv)"
expect 1 'there already' "$FULCRUM" results --csv all.csv
expect 0 'curves.html' "$FULCRUM" results --page curves.html
grep -q 'Results over trials' curves.html || fail "curves.html is no page"
expect 0 '"score": 100.0' "$FULCRUM" results --json --participant P1
expect 2 'one thing at a time' "$FULCRUM" results --json --participants
expect 2 'leave them out' "$FULCRUM" results --delete-participant P1 --scenario stick --yes
expect 2 'leave them out' "$FULCRUM" results --participants --participant P1
expect 2 'belongs to' "$FULCRUM" results --yes
[ "$("$FULCRUM" results | grep -c stick)" = 3 ] || fail "what was refused was done"

# --- what is read by a spreadsheet is no formula, and no digit of a seed is lost; what is printed to a full disk says so
cp -rL "$(dirname "$FULCRUM")/content/scenarios/stick" '=1+1'
expect 3 'Not completed' "$FULCRUM" run '=1+1/scenario.yaml' --headless --seed 9007199254740993 --seconds 0.2 --participant P9
expect 0 'odd.csv' "$FULCRUM" results --csv odd.csv --participant P9
grep -q ",'=1+1/scenario.yaml,.*,9007199254740993," odd.csv || fail "the CSV holds a formula, or another seed: $(tail -n 1 odd.csv)"
expect 0 'Deleted: P9' "$FULCRUM" results --delete-participant P9 --yes
"$FULCRUM" results --json >/dev/full 2>said && fail "a full disk is no error"
grep -q 'could not be written to its end' said || fail "of a full disk is said: $(cat said)"
expect 2 'it is empty' "$FULCRUM" results --delete-participant '' --yes

# --- the report's command repeats the trial, whatever its folder is called
grep -o 'fulcrum replay [^<]*' "of p2's/report.html" | sed "s/&#39;/'/g; s/&apos;/'/g; s/&amp;/\\&/g; s/^fulcrum/\"\$FULCRUM\"/" >again.sh
expect 0 'the same as recorded, bit for bit' bash again.sh
[ -s "$(find "$runs" -newer again.sh -name report.html)" ] || fail "a replay leaves no report"

# --- names that cannot be, and a motion that is nobody's
for name in '' ' P' '=1+1' $'a\tb'; do expect 2 'participant' "$FULCRUM" run stick --headless --participant "$name"; done
expect 2 "nobody's trial" "$FULCRUM" run stick --headless --participant P1 --device replay:nobody/tape

# --- consent
expect 0 'P1 consents' "$FULCRUM" results --consents P1
expect 0 'P1 +2 +yes' "$FULCRUM" results --participants
expect 0 'P1 has withdrawn' "$FULCRUM" results --withdraws P1
expect 0 'P1 +2 +no' "$FULCRUM" results --participants
expect 1 'no participant' "$FULCRUM" results --consents nobody

# --- deletion asks; then no row, no byte of the name and no file of the trials is left, and what is not theirs stays
echo mine >"of p2's/notes.txt"
expect 2 'nothing was deleted' "$FULCRUM" results --delete-participant P2 </dev/null
expect 0 'Deleted: P2, 1 trials' "$FULCRUM" results --delete-participant P2 --yes
[ "$(ls "of p2's")" = notes.txt ] || fail "left of P2: $(ls "of p2's")"
first=$(find "$runs" -maxdepth 1 -name 'stick-*' | LC_ALL=C sort | head -n 1)
expect 3 'Not completed' "$FULCRUM" run stick --headless --hand still --seconds 0.5 --out "$first" --force
expect 0 'holds something else' "$FULCRUM" results --delete-participant P1 --yes
[ -s "$first/trace.csv" ] || fail "a run that is nobody's was deleted"
[ "$("$FULCRUM" results --json)" = '[]' ] || fail "rows are left"
grep -q 'P1\|P2' "$store"* && fail "a name is left in the file"
[ "$(stat -c %a "$store")" = 600 ] || fail "others may read the results"

# --- a recording that cannot be removed keeps its row, so that a second try finds it
expect 0 'score' "$FULCRUM" run stick --headless --participant P4 --out locked/run
if [ "$(id -u)" != 0 ]; then
  chmod a-w locked/run
  expect 1 'still among the results' "$FULCRUM" results --delete-participant P4 --yes
  chmod u+w locked/run
fi
expect 0 'Deleted: P4' "$FULCRUM" results --delete-participant P4 --yes

# --- what was moved and left a link behind is found there, and goes
expect 0 'score' "$FULCRUM" run stick --headless --participant P4 --out moved/run
mkdir large && mv moved large/ && ln -s large/moved moved
mv large away # a disk that is not there now
expect 1 'leads nowhere' "$FULCRUM" results --delete-participant P4 --yes
mv away large
expect 0 'Deleted: P4, 1 trials, [1-9]' "$FULCRUM" results --delete-participant P4 --yes
[ -e large/moved/run ] && fail "left of P4: $(ls large/moved/run)"

# --- the start page's file is written first: where it cannot be, nothing is deleted
if [ "$(id -u)" != 0 ]; then
  expect 0 'score' "$FULCRUM" run stick --headless --participant P4 --out kept
  mkdir -p shut/fulcrum
  echo '{"participant": "P4"}' >shut/fulcrum/start.json
  chmod a-w shut/fulcrum
  XDG_CONFIG_HOME=$work/shut expect 1 'nothing was deleted, since .*start.json names P4. Cannot write .*start.json: permission is refused' "$FULCRUM" results --delete-participant P4 --yes
  chmod u+w shut/fulcrum
  XDG_CONFIG_HOME=$work/shut expect 0 'Deleted: P4' "$FULCRUM" results --delete-participant P4 --yes
  grep -q P4 shut/fulcrum/start.json && fail "the start page remembers who was deleted"
fi

# --- an interrupted deletion is gone on with; without a proof that a recording is theirs, the row stays
expect 0 'score' "$FULCRUM" run stick --headless --participant P5 --out half
rm half/trace.csv half/tape # as a kill would have left it
expect 0 'Deleted: P5' "$FULCRUM" results --delete-participant P5 --yes
[ -e half ] && fail "left of P5: $(ls half)"
expect 0 'score' "$FULCRUM" run stick --headless --participant P6 --out unknown
rm unknown/trace.csv unknown/summary.json
expect 1 'nobody can tell' "$FULCRUM" results --delete-participant P6 --yes
expect 0 'P6' "$FULCRUM" results --participants
rm -r unknown
expect 0 'no recording in .*unknown' "$FULCRUM" results --delete-participant P6 --yes

# --- a changed task is no best of the scenario's own, and says so; what it leaves is its owner's alone
expect 0 '.' "$FULCRUM" run stick --headless --set dwell=0.2 --participant P7 --out changed
expect 0 '[0-9][*]' "$FULCRUM" results --participant P7
for file in changed changed/report.html changed/trace.csv changed/tape; do
  case $(stat -c %a $file) in ?00) ;; *) fail "others may read $file" ;; esac
done
# The start page forgets who is deleted.
mkdir -p config/fulcrum
echo '{"participant": "P7", "scenario": "stick"}' >config/fulcrum/start.json
XDG_CONFIG_HOME=$work/config expect 0 'Deleted: P7' "$FULCRUM" results --delete-participant P7 --yes
grep -q P7 config/fulcrum/start.json && fail "the start page remembers who was deleted"

# --- a guided trial has no score, and says so wherever it is told of; a replay tells the same
expect 0 'guided: this trial has no score' "$FULCRUM" run stick --headless --set guidance.gain=1 --participant P8 --out led
expect 0 'guided' "$FULCRUM" results --participant P8
"$FULCRUM" results --participant P8 | grep -q '[0-9][*]' && fail "a guided trial has a score: $("$FULCRUM" results)"
expect 0 '"guided": true' "$FULCRUM" results --json --participant P8
expect 0 '"score": null' "$FULCRUM" results --json --participant P8
grep -q '"guided": true' led/summary.json || fail "summary.json does not say that it was guided"
grep -q 'Guided: no points' led/report.html || fail "report.html does not say that it was guided"
expect 0 'the same as recorded, bit for bit' "$FULCRUM" replay led/tape --out led-again
grep -q 'Guided: no points' led-again/report.html || fail "the replay's report does not say that it was guided"
grep -q '"guided"' of*/summary.json nobody/summary.json 2>/dev/null && fail "what was not guided says that it was"
expect 0 'guided.html' "$FULCRUM" results --page guided.html --participant P8
grep -q 'There is no trial' guided.html || fail "a guided trial has a place in a learning curve"

# --- results that cannot be used refuse the trial before it begins
rm -f "$store"*
printf 'no database at all, by its first bytes, but long enough to be looked at as one. %0500d' 0 >"$store"
expect 1 'damaged' "$FULCRUM" run stick --headless --participant P1
[ "$failures" = 0 ] || exit 1
echo "all good"
