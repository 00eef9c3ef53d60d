#!/usr/bin/env bash
# drivers_test.sh TEST_DRIVERS_KERNEL [ARGS]: the drivers' tests in a machine of their own.
# shellcheck source=tests/drivers_kernel/machine.sh
. "$(dirname "$(readlink -f "$0")")/machine.sh"
bring "$1"
bring "$(command -v udevadm)" # which is systemd-udevd, too, where it is called so
bring_modules vhci-hcd usbhid hid-generic hid-playstation uhid evdev
boot 30 512 "$(basename "$1")" "${@:2}"
