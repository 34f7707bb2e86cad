#!/usr/bin/env bash
# Rewrites the expected outputs that have changed; review the difference.
# Usage: scripts/update_golden.sh [NAME | FOLDER]...   (default: all)
#   NAME    a mechanism, such as planar_four_bar for mechanisms/planar/four_bar.yaml: its golden;
#           or a folder of tests/cli or tests/golden with a file cmd: its expected output
#   FOLDER  the path of such a folder
# The program is built first, unless KINESTAT in the environment is the path of a program.
set -euo pipefail

caller=$PWD
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
program=${KINESTAT:-}
[[ -z $program || $program == /* ]] || program=$caller/$program
if [[ -z $program ]]; then
  scripts/setup.sh test
  [[ -f build/release/build.ninja ]] || cmake --preset release
  cmake --build --preset release --target kinestat
  program=$root/build/release/app/kinestat
fi

declare -A mechanisms=()  # the file of each, by name
while IFS= read -r file; do
  name=${file#mechanisms/}
  name=${name%.yaml}
  mechanisms[${name//\//_}]=$root/$file
done < <(find mechanisms -name '*.yaml' | sort)

update_case() { UPDATE=1 python3 tests/cli/run_case.py "$1" --program "$program"; }
update_report() { python3 -B tests/golden/run_golden.py "$1" --program "$program" --update; }

update() {  # what a word of the command line names
  local word=$1 folder
  for folder in "tests/golden/$word" "tests/cli/$word"; do
    [[ $word != */* && -f $folder/cmd ]] && { update_case "$root/$folder"; return; }
  done
  [[ -n ${mechanisms[$word]:-} ]] && { update_report "${mechanisms[$word]}"; return; }
  folder=$(cd "$caller" && realpath -m -- "$word")
  [[ -f $folder/cmd ]] && { update_case "$folder"; return; }
  folder=${folder##*/}
  [[ -n ${mechanisms[$folder]:-} ]] && { update_report "${mechanisms[$folder]}"; return; }
  echo "update_golden.sh: '$word' is neither a mechanism nor a folder with a file cmd" >&2
  exit 2
}

if [[ $# -eq 0 ]]; then
  for command in tests/{cli,golden}/*/cmd; do
    [[ -f $command ]] && set -- "$@" "$root/$(dirname "$command")"
  done
  set -- "$@" "${!mechanisms[@]}"
fi
status=0
for word in "$@"; do
  update "$word" || status=1
done
exit "$status"
