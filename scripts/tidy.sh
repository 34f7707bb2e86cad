#!/usr/bin/env bash
# Runs clang-tidy on the files changed since a commit (default: HEAD), or on all.
# Usage: scripts/tidy.sh [BASE | --all]   (about 8 s per file)
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

stop() {
  echo "tidy.sh: $*" >&2
  exit 4
}

command -v clang-tidy >/dev/null ||
  stop "clang-tidy is missing; on Debian 12: scripts/setup.sh lint"
# The compiler's options: of the other presets the database knows no single source.
database=build/debug
[[ -f $database/compile_commands.json ]] || cmake --preset debug -DBUILD_TESTING=ON >/dev/null ||
  stop "cmake --preset debug fails; first: scripts/test.sh"

changed_files() {
  if [[ $1 == --all ]]; then
    find app lib tests -name '*.cpp'
    return
  fi
  git diff --name-only --diff-filter=d "$1" -- app lib tests &&
    git ls-files --others --exclude-standard -- app lib tests
}

changed=$(changed_files "${1:-HEAD}") || stop "no such commit: ${1:-HEAD}"

# A header is seen through the source beside it.
sources=()
while read -r file; do
  [[ -f $file ]] && grep -qF "$PWD/$file" "$database/compile_commands.json" && sources+=("$file")
done < <(sed -n 's/\.[hc]pp$/.cpp/p' <<<"$changed" | sort -u)

[[ ${#sources[@]} -gt 0 ]] || { echo "tidy.sh: nothing to look at"; exit 0; }
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" \
  clang-tidy --quiet -p "$database" --extra-arg=-Wno-unknown-warning-option
