#!/usr/bin/env bash
# Checks that builds do not depend on place and time: builds in two folders and compares the bytes of
# every library, the program and the packages. Prints their checksums; exit status 1 if any differ.
# Usage: scripts/reproducible.sh [--against BUILD]   (a quarter of an hour per build on two cores)
# --against: BUILD, an existing complete release build of this checkout, is one of the two.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
against=
if [[ $# -gt 0 ]]; then
  [[ $# -eq 2 && $1 == --against ]] || { sed -n 4,5p "${BASH_SOURCE[0]}" >&2; exit 2; }
  against=$(realpath -e -- "$2")
fi
"$root/scripts/setup.sh" package

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# A compiler that is asked again, not what it said before.
export CCACHE_DISABLE=1

made_in() {  # of a checkout, in its build folder
  [[ -f $1/build.ninja ]] ||
    (cd "${1%/build/release}" && cmake --preset release -DBUILD_TESTING=OFF) >"$folder/log" ||
    { cat "$folder/log" >&2; exit 4; }
  cmake --build "$1" --target packages >"$folder/log" || { tail -n 50 "$folder/log" >&2; exit 4; }
  (cd "$1" && sha256sum app/kinestat lib/*.a lib/libkinestat.so.*.*.* packages/*.{deb,tar.gz})
}

# Another name, another length, another depth.
copies=("$folder/one")
[[ -n $against ]] || copies+=("$folder/a_longer_path/to_the_other")
for copy in "${copies[@]}"; do
  mkdir -p "$copy"
  git -C "$root" ls-files -z --cached --others --exclude-standard |
    tar -C "$root" --null --files-from - --create --file - | tar -C "$copy" --extract --file -
done
made_in "${copies[0]}/build/release" >"$folder/first"
made_in "${against:-"${copies[-1]}/build/release"}" >"$folder/second"

grep -v '\.a$' "$folder/first"
if ! diff "$folder/first" "$folder/second" >"$folder/differences"; then
  echo "reproducible.sh: these differ:" >&2
  cat "$folder/differences" >&2
  exit 1
fi
echo "reproducible.sh: $(wc -l <"$folder/first") files are the same in both"
