# For tests that run the program from outside: counts what went wrong in `failures` and goes on.
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE PATTERN COMMAND...: the exit code, and a pattern in what it says.
expect() {
  local code=$1 pattern=$2 said got
  shift 2
  said=$("$@" 2>&1)
  got=$?
  [ "$got" = "$code" ] || fail "$*: exit $got, not $code: $said"
  grep -qE -- "$pattern" <<<"$said" || fail "$*: says nothing like /$pattern/: $said"
}
