#!/usr/bin/env bash
# Installs what is missing, builds, and creates the packages: .deb files for the program, the library,
# its headers and Python, and a .tar.gz with all of these that runs from any folder. Prints their
# paths.
# Usage: scripts/package.sh [FOLDER]   (default: build/release/packages)
set -euo pipefail

[[ $# -le 1 && ${1:-} != -* ]] || {
  echo "usage: scripts/package.sh [FOLDER]" >&2
  exit 2
}
folder=$(realpath -m -- "${1:-.}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/release
[[ $# -gt 0 ]] || folder=$PWD/$build/packages

scripts/setup.sh package
[[ -f $build/build.ninja ]] || cmake --preset release -DBUILD_TESTING=OFF >&2
cmake --build "$build" --target packages >&2
made=("$PWD/$build"/packages/*.{deb,tar.gz})
mkdir -p "$folder"
for file in "${made[@]}"; do
  [[ $folder/${file##*/} -ef $file ]] || cp "$file" "$folder"
  printf '%s\n' "$folder/${file##*/}"
done
