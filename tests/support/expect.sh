# For tests that run the program from outside: counts what went wrong in `failures` and goes on.
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE PATTERN COMMAND...: the exit code, and a pattern in what it says.
expect() {
  expect_each "$1" "$2" -- "${@:3}"
}

# expect_each CODE PATTERN... -- COMMAND...: the exit code, and every pattern in what it says; the command runs once.
expect_each() {
  local code=$1 patterns=() pattern said got
  shift
  while [ "$1" != -- ]; do
    patterns+=("$1")
    shift
  done
  shift
  said=$("$@" 2>&1)
  got=$?
  [ "$got" = "$code" ] || fail "$*: exit $got, not $code: $said"
  for pattern in "${patterns[@]}"; do
    grep -qE -- "$pattern" <<<"$said" || fail "$*: says nothing like /$pattern/: $said"
  done
}
