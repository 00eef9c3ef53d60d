#!/usr/bin/env bash
# results_kill_test.sh [TIMES]: a session is killed at random moments, TIMES times (200). Afterwards each trial among the
# results is whole, with its recording, and each that had said it was finished is there. $FULCRUM is the program.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
times=${1:-200}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted
export XDG_DATA_HOME=$work/data
RANDOM=7
finished=0

run() { "$FULCRUM" run stick --headless --seconds 4 --participant P1 >said 2>errors; }
begin=$(date +%s%N)
run
length=$((($(date +%s%N) - begin) / 1000000)) # ms that one takes here

# The trials' folders and hashes, as a table tells them: the two last columns.
for ((i = 1; i <= times; ++i)); do
  run &
  child=$!
  sleep "$(printf '0.%03d' $((RANDOM * (length + length / 4) / 32768 % 1000)))"
  kill -KILL $child 2>/dev/null
  wait $child 2>/dev/null
  grep -q 'report lie in' said && finished=$((finished + 1)) # it says so once all is on disk
  rm -f trials.csv
  "$FULCRUM" results --csv trials.csv >/dev/null 2>errors || fail "after kill $i: $(cat errors)"
  rows=$(($(wc -l <trials.csv) - 1))
  [ "$rows" -gt "$finished" ] || fail "after kill $i: $rows trials, of $((finished + 1)) that were finished"
done

while IFS=, read -r folder sum; do
  [ "$(sha256sum <"$folder/trace.csv" | cut -d ' ' -f 1)" = "$sum" ] || fail "$folder: the trace is not the trial's"
  grep -q '</html>' "$folder/report.html" || fail "$folder: the report is not whole"
  tail -c 3 "$folder/summary.json" | grep -q '}' || fail "$folder: the summary is not whole"
done < <(tail -n +2 trials.csv | awk -F, '{ print $(NF - 1) "," $NF }')
[ "$failures" = 0 ] || exit 1
echo "$times kills, $finished of the trials were finished before, $rows are among the results"
