#!/usr/bin/env bash
# libm_test.sh LIBRARY|PROGRAM...: object files of what reaches a tick or a bake call nothing of the C library whose last
# bit depends on the processor. What they may call instead is in haptics/math/functions.h. Exact everywhere, and allowed:
# sqrt, fmod, remainder, fma, floor, ceil, round and their like.
set -euo pipefail
inexact='a?(sin|cos|tan)(h|pi)?|atan2(pi)?|sincos|exp(2|10)?|expm1|log(2|10|1p)?|pow|cbrt|hypot|c?abs_?|erfc?|[lt]gamma|gamma|[jy][01n]'
complex='c(abs|arg|exp|log|pow|sqrt|(a?(sin|cos|tan)h?))'
# std::abs(double) is no call; abs(int) is exact.
pattern="^((__)?(${inexact/c?abs_?|/})|$complex)(f|l|f32|f64|f128)?(_finite)?\$"
failures=0
for file in "$@"; do
  while read -r object symbol; do
    echo "FAILED: $object calls $symbol"
    failures=$((failures + 1))
  done < <(nm -A --undefined-only "$file" | sed -E 's/^(.*):[^:]* U ([^@]*).*$/\1 \2/' | awk -v p="$pattern" '$2 ~ p')
done
[ "$failures" = 0 ] || {
  echo "$failures calls whose last bit depends on the processor: take the function of haptics/math/functions.h, or of rotation.h for Eigen's AngleAxis, slerp and angularDistance."
  exit 1
}
echo "no such call in $# files"
