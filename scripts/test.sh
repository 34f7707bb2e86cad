#!/usr/bin/env bash
# Installs what is missing, builds everything, and runs every test.
# Usage: scripts/test.sh [--sanitize] [CTEST ARGUMENT]...   for example: scripts/test.sh -L cli
# With CI=true in the environment, warnings are errors.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=release
packages="test"
if [[ ${1:-} == --sanitize ]]; then
  preset=sanitize
  packages="sanitize"
  shift
fi
[[ ${CI:-} == true ]] && werror=ON || werror=OFF

"$root/scripts/setup.sh" "$packages"
[[ $preset == sanitize ]] || "$root/scripts/setup.sh" browser viewers ||
  echo "test.sh: no browser could be installed; tests of pages are skipped" >&2
cd "$root"
cmake --preset "$preset" -DBUILD_TESTING=ON -DKINESTAT_WERROR="$werror"
cmake --build --preset "$preset"
echo "test.sh: $preset is built after ${SECONDS} s"
ctest --preset "$preset" --parallel "$(nproc)" --no-tests=error "$@"
