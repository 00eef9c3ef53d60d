# Shared by tools/run, tools/test and tools/bench: install what is missing, configure, build. Messages go to stderr, so
# that stdout is the program's alone; where there is nothing to do, nothing is said.
# shellcheck shell=bash

top=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
jobs=$(nproc)

say() { printf 'Fulcrum: %s\n' "$*" >&2; }
fail() {
  say "$*"
  exit 1
}

# packages KIND...: their names, from the list.
packages() {
  local kind
  for kind in "$@"; do
    awk -v kind="$kind" '$1 == kind { print $2 }' "$top/tools/setup/packages"
  done | LC_ALL=C sort
}

# install_packages KIND...: those that are missing, as root or through sudo.
install_packages() {
  local missing become=() line code=0
  # shellcheck disable=SC1090
  if ! (. "${FULCRUM_OS_RELEASE:-/etc/os-release}" && [ "${ID-}:${VERSION_ID-}" = debian:12 ]) 2>/dev/null; then
    check_commands "$@"
    return
  fi
  # shellcheck disable=SC2046
  mapfile -t missing < <(LC_ALL=C comm -23 <(packages "$@") <(
    dpkg-query -W -f '${db:Status-Status} ${Package}\n' $(packages "$@") 2>/dev/null | sed -n 's/^installed //p' | LC_ALL=C sort))
  [ ${#missing[@]} -gt 0 ] || return 0

  line="apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || fail "packages are missing and there is no sudo. As root, run:
  $line"
    become=(sudo)
    say "packages are missing; installing them needs sudo, which may ask for your password."
  fi
  say "installing what is missing (${#missing[@]} of the packages in tools/setup/packages, and what they need): a minute or two ..."
  "${become[@]}" bash "$top/tools/setup/apt" "${missing[@]}" </dev/null >&2 || code=$?
  case $code in
    0) ;;
    70) fail "apt could not install the packages (its message is above). Is there a network? Then run this again, or, as root:
  $line" ;;
    *) fail "sudo refused. As root, run:
  $line" ;;
  esac
}

# check_commands KIND...: elsewhere than on Debian 12 nothing is installed; the tools must be there already.
check_commands() {
  local wanted=(cmake ninja g++ pkg-config) missing=() command version
  [[ " $* " != *" test "* ]] || wanted+=(Xvfb openbox xdotool import)
  for command in "${wanted[@]}"; do
    command -v "$command" >/dev/null || missing+=("$command")
  done
  [ ${#missing[@]} = 0 ] ||
    fail "Debian 12 is expected. This is another system, and it lacks: ${missing[*]}. Install them and the libraries in tools/setup/packages."
  version=$(cmake --version | sed -n '1s/[^0-9]*//p')
  [ "$(printf '%s\n' 3.25 "$version" | sort -V | head -n 1)" = 3.25 ] || fail "CMake 3.25 or newer is needed; this is $version."
  [ -e "$top/build/release/build.ninja" ] ||
    say "Debian 12 is expected. This is another system: going on with the compiler and libraries it has."
}

# build PRESET TESTS [TARGET...]: TESTS is ON or OFF; OFF leaves tests alone that are on already, so that tools/run and
# tools/test share one build folder.
build() {
  local preset=$1 tests=$2 folder=$top/build/$1 lock
  if ! mkdir -p "$folder" 2>/dev/null || ! { exec {lock}>"$top/build/.lock"; } 2>/dev/null; then
    fail "$top/build cannot be made or written into, and that is where Fulcrum is built. Make $top yours (chown -R $(id -un) '$top'), or copy it to a folder of yours and run this there."
  fi
  flock "$lock" # a second call waits for the first
  if [ -e "$folder/build.ninja" ] && grep -q '^FULCRUM_TESTS:[A-Z]*=ON$' "$folder/CMakeCache.txt"; then tests=ON; fi
  if [ ! -e "$folder/build.ninja" ] || [ "$top/CMakePresets.json" -nt "$folder/build.ninja" ] ||
     ! grep -q "^FULCRUM_TESTS:[A-Z]*=$tests\$" "$folder/CMakeCache.txt"; then
    say "configuring ($preset) ..."
    (cd "$top" && cmake --preset "$preset" -DFULCRUM_TESTS="$tests") >/dev/null || fail "CMake's message is above."
  fi
  (cd "$top" && cmake --build --preset "$preset" --parallel "$jobs" ${3:+--target "${@:3}"}) 2>&1 | show_build >&2 ||
    fail "the build failed; the compiler's message is above."
  exec {lock}>&-
}

# Ninja's progress in one line on a terminal, nothing where there was nothing to do.
show_build() {
  local line busy=
  while IFS= read -r line; do
    case $line in
      *'] Re-checking globbed directories...' | 'ninja: no work to do.') ;;
      \[*/*\]*)
        if [ -t 1 ]; then
          printf '\r\033[K%.79s' "$line"
          busy=1
        else
          printf '%s\n' "$line"
        fi ;;
      *)
        printf '%s%s\n' "${busy:+$'\n'}" "$line"
        busy= ;;
    esac
  done
  [ -z "$busy" ] || printf '\r\033[K'
}
