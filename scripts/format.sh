#!/usr/bin/env bash
# Lays out the C and C++ files with clang-format 14.
# Usage: scripts/format.sh [--check]   (--check changes nothing; status 77 without clang-format 14)
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
mode=(-i)
[[ ${1:-} == --check ]] && mode=(--dry-run --Werror --ferror-limit=1)

formatter=
for candidate in clang-format-14 clang-format; do
  if [[ $("$candidate" --version 2>/dev/null || true) == *"version 14."* ]]; then
    formatter=$candidate
    break
  fi
done
if [[ -z $formatter ]]; then
  echo "format.sh: needs clang-format 14; on Debian 12: scripts/setup.sh lint" >&2
  [[ ${1:-} == --check ]] && exit 77
  exit 4
fi

find app lib tests include examples \( -name '*.hpp' -o -name '*.cpp' -o -name '*.[hc]' \) -print0 |
  xargs -0 --no-run-if-empty "$formatter" --style=file "${mode[@]}"
