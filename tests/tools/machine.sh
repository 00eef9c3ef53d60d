# A machine made of stand-ins, to try tools/run and tools/test on: a copy of the scripts in a folder with a space in its
# name, a PATH with nothing on it but harmless commands, and fake ones that write what they are asked to $box/log.
# shellcheck shell=bash disable=SC2016,SC2034
set -euo pipefail

repo=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT
tree="$box/a tree"
mkdir -p "$tree/tools" "$box/bin"
cp -r "$repo/tools/run" "$repo/tools/test" "$repo/tools/setup" "$tree/tools/"
cp "$repo/CMakePresets.json" "$tree/"
for command in bash sh env awk sed sort comm grep mkdir dirname readlink flock nproc cat chmod touch tail head sleep setarch; do
  ln -s "$(command -v $command)" "$box/bin/$command"
done

# fake NAME < SCRIPT
fake() {
  { printf '#!/bin/bash\n'; cat; } >"$box/bin/$1"
  chmod +x "$box/bin/$1"
}
fake id <<<'cat "$BOX/uid"'
fake dpkg-query <<<'cat "$BOX/installed"'
fake apt-get <<'E2'
echo "apt-get $*" >>"$BOX/log"
[ ! -e "$BOX/offline" ] || { echo "E: no network" >&2; exit 100; }
[[ " $* " != *" install "* ]] || awk '/^(run|test|kernel) / { print "installed " $2 }' "$TREE/tools/setup/packages" >"$BOX/installed"
E2
fake cmake <<'E2'
echo "cmake $*" >>"$BOX/log"
case $1 in
  --version) echo "cmake version $(cat "$BOX/cmake_version")" ;;
  --preset)
    mkdir -p "build/$2"
    touch "build/$2/build.ninja"
    for tests in "$@"; do :; done
    echo "FULCRUM_TESTS:BOOL=${tests#-DFULCRUM_TESTS=}" >"build/$2/CMakeCache.txt" ;;
  --build)
    [ ! -e "$BOX/broken" ] || { echo "error: broken"; exit 1; }
    if [ -e "build/$3/fulcrum" ]; then echo "ninja: no work to do."; exit; fi
    echo "[1/1] Linking fulcrum"
    printf '#!/bin/bash\necho "fulcrum in $PWD:$(printf " <%%s>" "$@")"\n[ "${1-}" != seven ] || exit 7\n' >"build/$3/fulcrum"
    chmod +x "build/$3/fulcrum" ;;
esac
E2
fake ctest <<<'echo "ctest $* | jobs: ${CTEST_PARALLEL_LEVEL-}"'
for command in ninja g++ pkg-config Xvfb openbox xdotool import; do fake "$command" </dev/null; done

# A fresh Debian 12, as root.
fresh() {
  rm -rf "$tree/build" "$box/broken" "$box/offline" "$box/bin/sudo"
  : >"$box/log"
  : >"$box/installed"
  echo 0 >"$box/uid"
  echo 3.25.1 >"$box/cmake_version"
  printf 'ID=debian\nVERSION_ID="12"\n' >"$box/os-release"
}

# on [NAME=VALUE...] COMMAND...: on that machine, from its root folder; leaves $code, $out (stdout) and $err (stderr).
on() {
  code=0
  out=$(cd / && env -i PATH="$box/bin" BOX="$box" TREE="$tree" FULCRUM_OS_RELEASE="$box/os-release" "$@" 2>"$box/err") || code=$?
  err=$(cat "$box/err")
}

# expect WHAT GOT PATTERN: a shell pattern that all of GOT has to match.
expect() {
  # shellcheck disable=SC2053
  [[ $2 == $3 ]] || { printf 'FAILED: %s\n  got:      %s\n  expected: %s\n' "$1" "$2" "$3"; exit 1; }
}
