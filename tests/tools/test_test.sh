#!/usr/bin/env bash
# tools/test: what it installs, builds and asks of ctest.
# shellcheck source=tests/tools/machine.sh
. "$(dirname "$(readlink -f "$0")")/machine.sh"
test="$tree/tools/test"

fresh
on "$tree/tools/run" --build
echo "installed g++" >"$box/installed"
: >"$box/log"
on "$test"
expect "installs the tests' packages" "$(cat "$box/log")" "*install *libgtest-dev*xvfb*"
expect "but not those of the tests that boot a kernel" "$(cat "$box/log")" "!(*qemu-system*)"
expect "turns the tests on" "$(cat "$box/log")" "*cmake --preset release -DFULCRUM_TESTS=ON*"
expect "builds everything" "$(grep -e --build "$box/log")" "!(*--target*)"
expect "leaves out long" "$code:$out" "0:ctest --preset release --no-tests=error -LE ^long\$ | jobs: [1-9]*"

: >"$box/log"
on "$test" --all
expect "--all" "$out" "ctest --preset release --no-tests=error | *"
expect "a kernel that cannot be had: a sentence, and the tests go on" "$code:$err" "0:*the tests' kernel comes by apt*so the tests with the label kernel are skipped*"
expect "nothing is configured again" "$(grep -c -e --preset\ release\ -D "$box/log" || true)" 0
on "$test" -R "A name" --output-on-failure
expect "ctest's arguments" "$out" "*-LE ^long\$ -R A name --output-on-failure | *"
echo "installed g++" >"$box/installed"
: >"$box/log"
on "$test" -L kernel
expect "-L kernel" "$out:$(cat "$box/log")" "*-LE ^long\$ -L kernel | *:*install *qemu-system-x86*"
on "$test" -LE gpu
expect "one more label to leave out" "$out" "*-LE gpu|^long\$ | *"
on "$test" --sanitize tsan
expect "--sanitize tsan" "$code:$out:$(cat "$box/log")" "0:ctest --preset tsan *-LE ^no-tsan\$|^long\$*:*cmake --build --preset tsan*"
: >"$box/log"
on "$test" --all --sanitize asan
expect "--all --sanitize asan" "$out" "ctest --preset asan *-LE ^no-asan\$ | *"
expect "its compiler is installed" "$(cat "$box/log")" "*install *clang*"
on "$test" --sanitize speed
expect "an unknown sanitizer" "$code:$err" "2:*asan or tsan*"
fake ctest <<<'exit 8'
on "$test"
expect "ctest's exit code" "$code" 8
