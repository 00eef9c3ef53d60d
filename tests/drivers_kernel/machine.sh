# A machine of its own for a test: Debian's kernel in QEMU, with nothing in it but what is brought, which runs one
# command. It counts time by the instructions that it has run (-icount), so that a busy host makes it take longer and
# nothing else: in there a millisecond is always enough for what it was enough for before.
# shellcheck shell=bash
# $FULCRUM_KERNEL: what tools/setup/kernel unpacked.
set -euo pipefail
PATH=$PATH:/usr/sbin:/sbin
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")

skip() {
  echo "skipped: $*"
  exit 77
}
for need in "qemu-system-x86_64 qemu-system-x86" "busybox busybox-static" "cpio cpio" "modprobe kmod" "udevadm udev"; do
  command -v "${need% *}" >/dev/null || skip "no ${need% *} (Debian package ${need#* }): \`tools/test -L kernel\` installs it"
done
[ -e "${FULCRUM_KERNEL:?}/vmlinuz" ] || skip "no kernel in $FULCRUM_KERNEL: \`tools/test -L kernel\` gets one"

box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT
root=$box/root
mkdir -p "$root"/{bin,dev,modules,proc,sys,tmp}
cp "$(command -v busybox)" "$root/bin/busybox"
cp "$here/init" "$root/init"

# bring PROGRAM: into /bin, its libraries where it looks for them.
bring() {
  local library
  cp "$1" "$root/bin/"
  ldd "$1" | grep -o '/[^ ]*' | while read -r library; do
    mkdir -p "$root$(dirname "$library")"
    cp -L "$library" "$root$library"
  done
}

# bring_modules NAME...: and those that they need, in the order in which they are loaded.
bring_modules() {
  local name file
  for name in "$@"; do
    modprobe -d "$FULCRUM_KERNEL" -S "$(basename "$FULCRUM_KERNEL"/lib/modules/*)" --show-depends "$name"
  done | awk '$1 == "insmod" && !seen[$2]++ { print $2 }' | while read -r file; do
    cp "$file" "$root/modules/"
    basename "$file" >>"$root/modules/order"
  done
}

# boot LIMIT_S MEMORY_MB COMMAND...: what it says comes out here, and its exit code is returned. It may take LIMIT_S by the
# machine's clock, and ten times that by the host's: past the first it is ended, past the second the machine is. Where it
# fails, what the kernel said follows.
boot() {
  local limit=$1 memory=$2 code=0 said
  shift 2
  echo "$limit" >"$root/limit"
  printf '%q ' exec "$@" >"$root/command"
  (cd "$root" && find . | cpio --quiet -o -H newc) >"$box/initrd"
  timeout --kill-after=5 $((10 * limit)) qemu-system-x86_64 -M q35 -accel tcg -icount shift=1,sleep=off -smp 1 -m "$memory" \
    -nodefaults -no-user-config -display none -no-reboot -serial "file:$box/console" -serial stdio \
    -kernel "$FULCRUM_KERNEL/vmlinuz" -initrd "$box/initrd" -append "console=ttyS0 panic=-1" </dev/null |
    stdbuf -oL tr -d '\r' | tee "$box/said" || code=$?
  said=$(sed -nE 's/^machine: (exit .*|out of time)$/\1/p' "$box/said")
  case $said in
    "exit 0") return 0 ;;
    "out of time") echo "FAILED: it had not ended after $limit s by the machine's clock." ;;
    exit*) echo "FAILED: $said." ;;
    *) echo "FAILED: the machine itself ended with $code (124: after its limit of $((10 * limit)) s) before the test did." ;;
  esac
  echo "The machine's kernel said last:"
  tail -n 60 "$box/console"
  return 1
}
