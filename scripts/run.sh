#!/usr/bin/env bash
# Installs what is missing, builds, and analyses mechanisms; reports go to reports/, for files without
# options with an HTML page.
# Usage: scripts/run.sh [OPTION | FILE]...   (default: the Ravigneaux train)
# Options are those of `kinestat analyze`; the exit status is that of the program.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
reports=$root/reports
start=$(date +%s.%N)

[[ $# -gt 0 ]] || set -- "$root/mechanisms/transmissions/ravigneaux.yaml"

quietly() {  # the output of a command, only when it fails
  local output
  output=$("$@" 2>&1) || {
    printf '%s\n' "$output" "run.sh: failed: $*" >&2
    exit 4
  }
}

"$root/scripts/setup.sh" build
# Only the first time: test.sh adds the tests to the same folder, and they may stay.
if [[ ! -f $build/build.ninja ]]; then
  echo "run.sh: building for the first time, which takes some minutes" >&2
  (cd "$root" && quietly cmake --preset release -DBUILD_TESTING=OFF)
fi
NINJA_STATUS='run.sh: step %f of %t, %p after %e s: ' cmake --build "$build" --target kinestat kinestat_shared kinestat_shell_files >&2 || {
  echo "run.sh: failed: the build of kinestat" >&2
  exit 4
}

mkdir -p "$reports"
status=0
"$build/app/kinestat" analyze --out "$reports" "$@" || status=$?
# Options are those of `analyze`; the messages of the page are the same ones.
if [[ " $*" != *" -"* ]]; then
  "$build/app/kinestat" report --out "$reports/report.html" "$@" >/dev/null 2>&1 || true
fi

echo
mapfile -t written < <(find "$reports" -type f -newermt "@$start" | sort)
if [[ ${#written[@]} -gt 0 ]]; then
  echo "Written:"
  printf '  %s\n' "${written[@]}"
else
  echo "No report was written."
fi
if [[ " ${written[*]} " == *" $reports/report.html "* ]]; then
  echo "Open in a browser: $reports/report.html"
fi
echo "The program: $build/app/kinestat; to install it: scripts/package.sh, which makes packages,"
echo "or: cmake --install $build --prefix ~/.local"
exit "$status"
