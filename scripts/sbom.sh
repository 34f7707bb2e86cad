#!/usr/bin/env bash
# Lists the third-party code in the program, with versions and licences: SPDX 2.3 as JSON.
# Usage: scripts/sbom.sh [FILE]   (default: standard output)
# The program is built if necessary; the libraries in it are reported by the linker and the compiler.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
[[ $# -le 1 && ${1:-} != -* ]] || { sed -n 3p "${BASH_SOURCE[0]}" >&2; exit 2; }

"$root/scripts/setup.sh" package test
[[ -x $build/app/kinestat ]] || "$root/scripts/run.sh" --help >/dev/null
exec python3 -B "$root/packaging/sbom.py" --build "$build" ${1:+--out "$1"}
