#!/usr/bin/env bash
# piping_test.sh TEST_KERNEL_PIPING FULCRUM CONTENT CACHE: the program on emulated devices in a machine of their own.
# CACHE: a folder for the bakes of piping alone, which are brought there.
# shellcheck source=tests/drivers_kernel/machine.sh
. "$(dirname "$(readlink -f "$0")")/machine.sh"
test=$1 fulcrum=$2 content=$3 cache=$4
mkdir -p "$cache"
XDG_CACHE_HOME=$cache FULCRUM_CONTENT=$content "$fulcrum" run piping --headless --seconds 0.01 --out "$box/run" >"$box/baked" 2>&1 ||
  [ $? = 3 ] || { cat "$box/baked"; exit 1; }
bring "$test"
bring "$fulcrum"
bring_modules vhci-hcd usbhid hid-generic hid-playstation evdev
mkdir -p "$root/content/scenarios" "$root/cache"
cp -r "$content/devices" "$content/materials" "$root/content/"
cp -r "$content/scenarios/piping" "$root/content/scenarios/"
cp -r "$cache/fulcrum" "$root/cache/"
boot 150 1280 env FULCRUM_CONTENT=/content XDG_CACHE_HOME=/cache "$(basename "$test")"
