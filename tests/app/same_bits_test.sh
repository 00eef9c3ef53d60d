#!/usr/bin/env bash
# same_bits_test.sh runs|bakes|coarse_bakes|models native|nehalem SECONDS NAME...: the same bytes whatever the processor
# has. Each NAME is done as this machine does it, and again
#   native    with glibc told that the processor lacks FMA, and then AVX2 and all that came after it;
#   nehalem   in qemu, as a processor of 2008: no AVX at all, which Highway's targets see as well.
# runs: trace.csv of SECONDS of the scene in its expert's hand; bakes: every file that it leaves in the cache; coarse_bakes:
# the same with wider cells and spacings, in about a quarter of the time; models: what make_NAME writes. Without qemu-x86_64 the second leaves with 77. $FULCRUM, $FULCRUM_CONTENT, $TOOLS (of make_NAME).
set -euo pipefail
what=$1 where=$2 seconds=$3
shift 3
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted

newer=-AVX,-AVX2,-AVX512F,-AVX512VL,-AVX512BW,-AVX512DQ,-FMA,-FMA4,-ERMS
case $where in
  native) machines=(native no_FMA no_AVX2 no_AVX) ;;
  nehalem)
    command -v qemu-x86_64 >/dev/null || { echo "SKIPPED: no qemu-x86_64 (Debian's package qemu-user)"; exit 77; }
    machines=(native nehalem) ;;
esac

declare -A coarse=(
  [tutorial]='field.voxel=0.0015 shell.spacing=0.004'
  [teeth]='field.voxel=0.0005 shell.spacing=0.001'
  [ear]='field.voxel=0.0004 shell.spacing=0.001'
  [plate]='field.voxel=0.0016 shell.spacing=0.003'
  [knock]='field.voxel=0.002 shell.spacing=0.003'
  [stick]='field.voxel=0.002 shell.spacing=0.002'
  [sweep]='field.voxel=0.002 shell.spacing=0.003')

# bake MACHINE NAME FOLDER [KEY=VALUE...]: with the cache in the folder.
bake() {
  local machine=$1 name=$2 folder=$3 code=0 set=()
  for value in "${@:4}"; do set+=(--set "$value"); done
  XDG_CACHE_HOME=$folder on "$machine" "$FULCRUM" run "$name" --headless --seconds 0.01 --out "$folder.run" "${set[@]}" \
    >"$box/log" 2>&1 || code=$?
  [ "$code" = 0 ] || [ "$code" = 3 ] || { cat "$box/log"; return 1; }
}

# on MACHINE COMMAND...
on() {
  case $1 in
    native) "${@:2}" ;;
    no_FMA) GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4 "${@:2}" ;;
    no_AVX2) GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2 "${@:2}" ;;
    no_AVX) GLIBC_TUNABLES=glibc.cpu.hwcaps=$newer "${@:2}" ;;
    nehalem) qemu-x86_64 -cpu Nehalem "${@:2}" ;;
  esac
}

# did WHAT MACHINE NAME FOLDER: into the folder, and nothing but what is to be compared.
did() {
  local code=0
  case $1 in
    runs)
      on "$2" "$FULCRUM" run "$3" --headless --seconds "$seconds" --out "$4.run" >"$box/log" 2>&1 || code=$?
      [ "$code" = 0 ] || [ "$code" = 3 ] || { cat "$box/log"; return 1; }
      mv "$4.run/trace.csv" "$4" ;;
    bakes) bake "$2" "$3" "$4" ;;
    coarse_bakes)
      # shellcheck disable=SC2086  # words apart
      bake "$2" "$3" "$4" ${coarse[$3]} ;;
    models)
      on "$2" "$TOOLS/make_$3" "$4" >"$box/log" 2>&1 || { cat "$box/log"; return 1; } ;;
  esac
}

differ=0
printf '%-8s' ''
printf ' %-16s' "${machines[@]}"
echo
for name in "$@"; do
  printf '%-8s' "$name"
  wanted=
  for machine in "${machines[@]}"; do
    folder=$box/$name.$machine
    mkdir "$folder"
    did "$what" "$machine" "$name" "$folder"
    files=$(cd "$folder" && find . -type f | LC_ALL=C sort)
    [ -n "$files" ] || { echo "FAILED: $name left nothing on $machine"; exit 1; }
    sum=$(cd "$folder" && xargs -d '\n' cat <<<"$files" | sha256sum | cut -c1-16)
    printf ' %-16s' "$sum"
    : "${wanted:=$sum}"
    [ "$sum" = "$wanted" ] || differ=$((differ + 1))
    [ "$machine" = native ] || rm -rf "$folder"*
  done
  echo
done
[ "$differ" = 0 ] || { echo "FAILED: $differ of these $what differ from this machine's own"; exit 1; }
echo "all good"
