#!/usr/bin/env bash
# Scenarios that authors get wrong, a file each in broken/: `fulcrum check` says what the file's last lines say that it
# says, every sentence with line and column, and nothing else. $FULCRUM is the program.
set -uo pipefail
here=$(dirname "$(readlink -f "$0")")
. "$here/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
"$FULCRUM" new base >/dev/null || fail "no scenario could be made"
printf 'v 0 0 0\n' >base/tool.obj

seen=0
for file in "$here"/broken/*.yaml; do
  seen=$((seen + 1))
  name=$(basename "$file" .yaml)
  cp "$file" base/scenario.yaml
  said=$("$FULCRUM" check base/scenario.yaml 2>&1)
  code=$?
  wanted=$(sed -n 's/^# says: //p' "$file")
  said=$(sed "s#^base/scenario.yaml:##; s#$(pwd -P)/base#HERE#g" <<<"$said")
  [ "$code" = 1 ] || fail "$name: exit $code"
  [ "$said" = "$wanted" ] || fail "$name: says
$said
and not
$wanted"
  # `run` refuses what is wrong with the text in the same words; what only check looks for it may begin with.
  grep -qE 'deep in(to)? the scene' <<<"$wanted" && continue
  refused=$("$FULCRUM" run base/scenario.yaml --headless --seconds 0.01 --out X 2>&1) && fail "$name: runs"
  grep -qF -- "$(head -n 1 <<<"$wanted" | sed 's/^[0-9:]* //; s#HERE.*##')" <<<"$refused" || fail "$name: run says otherwise: $refused"
done
[ $seen -ge 30 ] || fail "only $seen files"

[ $failures = 0 ] && echo "all good: $seen files"
exit $((failures > 0))
