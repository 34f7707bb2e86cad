#!/usr/bin/env bash
# Measures which lines and branches of each module of lib/ the tests reach, and lists the lines that none does.
# Usage: scripts/coverage.sh [--write] [--only MODULES] [CTEST LABEL]...   (default: cli golden reference)
# Rebuilds everything without optimisation, which hides lines, and runs the unit tests and those of the
# labels: an hour of processor time. The table is printed, --write puts it into RELIABILITY.md, and
# build/coverage/unreached.txt lists the lines. --only 'core|math' selects the unit tests and libraries
# of these modules.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/coverage
write=() only=
while [[ ${1:-} == --* ]]; do
  case $1 in
    --write) write=(--write) ;;
    --only)
      only=${2:?--only needs modules}
      shift
      ;;
    *) sed -n 3p "${BASH_SOURCE[0]}" >&2; exit 2 ;;
  esac
  shift
done
labels=("$@")
[[ $# -gt 0 || -n $only ]] || labels=(cli golden reference)

"$root/scripts/setup.sh" test
cd "$root"
[[ -f $build/build.ninja ]] || cmake --preset coverage >&2
mapfile -t units < <(ninja -C "$build" -t targets all |
  sed -nE "s#^(tests/unit/(${only:-.*})/unit_[^:]*): CXX_EXECUTABLE.*#\1#p")
programs=("${units[@]}")
[[ ${#labels[@]} -eq 0 ]] || programs+=(app/kinestat)
ninja -C "$build" "${programs[@]}" >&2

# Every run of a program adds to the counts beside the objects. Tests may fail here, where time and
# memory are others, and still show what they reach.
find "$build" -name '*.gcda' -delete
for unit in "${units[@]}"; do
  (cd "$build/$(dirname "$unit")" && "./$(basename "$unit")" --gtest_brief=1) >&2 ||
    echo "coverage.sh: $unit fails here" >&2
done
for label in "${labels[@]}"; do
  (cd "$build" && ctest -L "^$label\$" --parallel "$(nproc)" --no-tests=error) >"$build/$label.log" ||
    sed -n '/tests failed out of/p; /^\t/p' "$build/$label.log" >&2
done

tests="unit${labels[*]:+ ${labels[*]}}"
exec python3 -B "$root/scripts/coverage.py" --build "$build" --tests "${tests// /, }" \
  ${only:+--only "$only"} "${write[@]}"
