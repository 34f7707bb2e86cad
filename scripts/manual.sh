#!/usr/bin/env bash
# Builds the manual as a website that works from the file system: build/manual/html/index.html.
# Usage: scripts/manual.sh [--program PROGRAM] [--out FOLDER]
# Pages come from manual/, from the mechanisms, and from the help of the program, which is built if
# necessary. Warnings are errors, and so are commands of the manual that fail.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$root/build/release/app/kinestat
out=$root/build/manual
own=yes

stop() {
  local status=$1
  shift
  printf 'manual.sh: %s\n' "$@" >&2
  exit "$status"
}

while [[ $# -gt 0 ]]; do
  [[ $1 == --program || $1 == --out ]] || stop 2 "unknown option '$1'; options are --program, --out"
  [[ $# -gt 1 ]] || stop 2 "$1 needs a value"
  if [[ $1 == --program ]]; then
    program=$2 own=no
  else
    out=$2
  fi
  shift 2
done

"$root/scripts/setup.sh" manual
# run.sh builds the program before it calls it.
[[ $own == no || -x $program ]] || "$root/scripts/run.sh" --help >/dev/null
[[ -x $program ]] || stop 4 "there is no program '$program'"

# Sphinx is Debian's, and so is the Python for which it is installed.
python=/usr/bin/python3
"$python" -B "$root/scripts/manual/manual.py" --program "$program" --out "$out/source"
"$python" -B -m sphinx -q -W --keep-going -j 2 -d "$out/doctrees" "$out/source" "$out/html"
echo "Open in a browser: $out/html/index.html"
