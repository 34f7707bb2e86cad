#!/usr/bin/env bash
# Mutates valid files and checks the promises of every command, for the given number of minutes.
# Usage: scripts/fuzz.sh MINUTES [FIRST SEED]   PROGRAM=… in the environment selects another program.
# Prints each complaint with its seed and its file; exit status 1 if there is any.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[[ $# -ge 1 && $# -le 2 ]] || { sed -n 2,4p "${BASH_SOURCE[0]}" >&2; exit 2; }
exec python3 -B "$root/tests/faults/mutation_test.py" \
  --program "${PROGRAM:-$root/build/release/app/kinestat}" --minutes "$1" ${2:+--first "$2"}
