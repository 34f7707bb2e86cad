#!/usr/bin/env bash
# Rewrites the expected outputs of tests/cli and tests/golden; review the difference.
# Usage: scripts/update_golden.sh [CASE FOLDER]...   (default: all)
set -euo pipefail

caller=$PWD
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/setup.sh" test
cd "$root"
[[ -f build/release/build.ninja ]] || cmake --preset release
cmake --build --preset release --target kinestat

cases=()
for folder in "$@"; do
  cases+=("$(cd "$caller" && realpath -- "$folder")")
done
if [[ $# -eq 0 ]]; then
  for command in "$root"/tests/{cli,golden}/*/cmd; do
    [[ -f $command ]] && cases+=("$(dirname "$command")")
  done
fi

status=0
for folder in "${cases[@]}"; do
  UPDATE=1 python3 tests/cli/run_case.py "$folder" --program build/release/app/kinestat || status=1
done
exit "$status"
