#!/usr/bin/env bash
# tools/run: what it installs, builds, says and passes on.
# shellcheck source=tests/tools/machine.sh
. "$(dirname "$(readlink -f "$0")")/machine.sh"
run="$tree/tools/run"

fresh
on "$run" one "two words"
expect "exit code" "$code" 0
expect "arguments reach fulcrum, in the caller's folder, and stdout is its alone" "$out" "fulcrum in /: <one> <two words>"
expect "installs without recommendations" "$(cat "$box/log")" "*apt-get*update*apt-get*--no-install-recommends install *g++*"
expect "no test packages" "$(grep install "$box/log")" "!(*gtest*|*xvfb*)"
expect "configures without tests" "$(cat "$box/log")" "*cmake --preset release -DFULCRUM_TESTS=OFF*"
expect "builds fulcrum, and all content where it cannot tell what is needed" "$(cat "$box/log")" "*cmake --build --preset release * --target fulcrum content"

: >"$box/log"
on "$run" seven
expect "fulcrum's exit code" "$code" 7
expect "nothing is said where there is nothing to do" "$err" ""
expect "nothing is installed or configured either" "$(cat "$box/log")" "cmake --build *"

# needs TARGET ARGS...
needs() {
  : >"$box/log"
  on "$run" "${@:2}"
  expect "what \`${*:2}\` needs" "$(grep -- --build "$box/log")" "*--target fulcrum $1"
}
mkdir -p "$tree/content/scenarios/teeth"
needs content_teeth run teeth --headless
needs content_teeth explain --set seed=2 teeth
needs content run ./teeth
needs content replay A/tape
needs content_texts list
needs content_texts results
needs content_texts --version
needs "fulcrum-studies content_piping" workprecision
needs "fulcrum-studies content" workprecision picture
needs "fulcrum-studies content" workprecision speed
needs "fulcrum-studies content_teeth" compare teeth
needs "fulcrum-studies fulcrum-import fulcrum-xr content" --build
needs "fulcrum-xr content_teeth" run teeth --xr
needs "fulcrum-import content_texts" import part.obj
rmdir "$tree/content/scenarios/teeth"

on "$run"
expect "without a display" "$out" "*: <run> <piping> <--headless> <--hand> <expert>"
on DISPLAY=:0 "$run"
expect "with a display: no arguments at all" "$out" "fulcrum in *: <>"
on WAYLAND_DISPLAY=wayland-0 "$run"
expect "with Wayland" "$out" "fulcrum in *: <>"
expect "the start page needs all scenes, and no studies" "$(grep -- --build "$box/log" | tail -n 1)" "*--target fulcrum content"
on "$run" --build
expect "--build does not start it" "$code:$out" "0:"
on "$run" --build more
expect "--build stands alone" "$code" 2

sed -i 's/=OFF/=ON/' "$tree/build/release/CMakeCache.txt"
: >"$box/log"
on "$run" --build
expect "tests that are on stay on" "$(cat "$box/log")" "cmake --build *"
touch -d "2001-01-01" "$tree/build/release/build.ninja"
on "$run" --build
expect "changed presets are taken up, tests stay on" "$(cat "$box/log")" "*cmake --preset release -DFULCRUM_TESTS=ON*"

touch "$box/broken"
on "$run"
expect "a failed build" "$code:$out:$err" "1::*error: broken*the build failed*"

fresh
echo 1000 >"$box/uid"
on "$run"
expect "neither root nor sudo: the line, and exit 1" "$code:$err" "1:*apt-get update && apt-get install -y --no-install-recommends cmake *"
expect "and apt is not called" "$(cat "$box/log")" ""
# shellcheck disable=SC2016
fake sudo <<<'echo "sudo" >>"$BOX/log"; exec "$@"'
on "$run" --build
expect "sudo is asked once" "$code:$(grep -c sudo "$box/log")" "0:1"

fresh
echo 1000 >"$box/uid"
fake sudo <<<'exit 1'
on "$run"
expect "sudo refused: the line, and exit 1" "$code:$err" "1:*sudo refused*apt-get install*"

fresh
touch "$box/offline"
on "$run"
expect "no network: a sentence, and exit 1" "$code:$err" "1:*E: no network*Is there a network*"

fresh
touch "$tree/build"
on "$run" --build
expect "a folder that cannot be built in: a sentence, and exit 1" "$code:$out:$err" "1::*build cannot be made or written into*chown*"
expect "and no message of mkdir's" "$err" "!(*mkdir:*)"
fresh
mkdir -p "$tree/build/.lock"
on "$run" --build
expect "a lock that cannot be written" "$code:$out:$err" "1::Fulcrum: *build cannot be made or written into*"

fresh
printf 'ID=ubuntu\nVERSION_ID="24.04"\n' >"$box/os-release"
on "$run" --build
expect "another system with the tools: goes on and says what is expected" "$code:$err" "0:*Debian 12 is expected*"
expect "and installs nothing" "$(cat "$box/log")" "!(*apt-get*)"
echo 3.22.1 >"$box/cmake_version"
on "$run" --build
expect "a CMake that is too old" "$code:$err" "1:*3.25 or newer*3.22.1*"
rm "$box/bin/ninja"
on "$run" --build
expect "another system without the tools" "$code:$err" "1:*lacks: ninja*"
