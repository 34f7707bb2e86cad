#!/usr/bin/env bash
# Lists what others wrote that is in the program, with versions and licences: SPDX 2.3 as JSON.
# Usage: scripts/sbom.sh [FILE]   (default: standard output)
# The program is built if it is not there; which libraries are in it the linker and compiler tell.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
[[ $# -le 1 && ${1:-} != -* ]] || { sed -n 3p "${BASH_SOURCE[0]}" >&2; exit 2; }

"$root/scripts/setup.sh" package test
[[ -x $build/app/kinestat ]] || "$root/scripts/run.sh" --help >/dev/null
exec python3 -B "$root/packaging/sbom.py" --build "$build" ${1:+--out "$1"}
