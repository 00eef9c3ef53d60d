#!/usr/bin/env bash
# one_definition_test.sh [ROOT]: no two types of one name in one namespace. Two programs may each have their own; but what
# is linked together and not inlined takes the code of one type for the other, and no compiler says so. Types in unnamed
# namespaces are their file's own.
set -euo pipefail
root=${1:-$(dirname "$(readlink -f "$0")")/../..}
cd "$root"
# A line for each type at the level of a namespace: what clang-format leaves at the margin.
types=$(find haptics drivers engine tools tests -name '*.h' -o -name '*.cpp' | LC_ALL=C sort | xargs awk '
  FNR == 1 { depth = 0 }
  /^namespace.*\{$/ {
    name = $0
    sub(/^namespace */, "", name)
    sub(/ *\{$/, "", name)
    space[++depth] = name == "" ? "(unnamed)" : name
    next
  }
  /^\}.*\/\/ namespace/ { --depth; next }
  /^(struct|class|enum|enum class|union) [A-Za-z_0-9]+ *(final *)?(: [^;]*)?\{/ {
    name = $0
    sub(/^(struct|class|enum class|enum|union) +/, "", name)
    sub(/[^A-Za-z_0-9].*/, "", name)
    path = ""
    for (i = 1; i <= depth; ++i) {
      if (space[i] == "(unnamed)") next
      path = path space[i] "::"
    }
    print path name, FILENAME ":" FNR
  }')
[ "$(wc -l <<<"$types")" -gt 300 ] || { echo "FAILED: only $(wc -l <<<"$types") types were seen"; exit 1; }
twice=$(cut -d' ' -f1 <<<"$types" | LC_ALL=C sort | uniq -d)
[ -z "$twice" ] || {
  for name in $twice; do
    echo "FAILED: $name is defined more than once:"
    grep "^$name " <<<"$types" | sed 's/.* /  /'
  done
  echo "Give one of them another name, or an unnamed namespace."
  exit 1
}
echo "all good: $(wc -l <<<"$types") types, each defined once"
