#!/usr/bin/env bash
# Golden regression for a CI: do the models still give the numbers that were checked once?
#
#   scripts/examples/golden_regression.sh --accept golden models/*.yaml    writes golden reports
#   scripts/examples/golden_regression.sh golden models/*.yaml             compares, exit status 1
#                                                                          if a number has changed
#
# Reports are compared by their numbers, so another version of the program, another path or the last
# digits do not matter. Whoever means a change accepts it, and the reviewer sees the numbers.
set -uo pipefail
accept=no
if [ "${1:-}" = --accept ]; then
  accept=yes
  shift
fi
golden=$1
shift
mkdir -p "$golden"
if [ "$accept" = yes ]; then
  exec kinestat analyze --quiet --out "$golden" "$@"
fi
reports=$(mktemp -d)
trap 'rm -rf "$reports"' EXIT
kinestat analyze --quiet --out "$reports" "$@"
status=$?
for report in "$reports"/*.report.json; do
  name=$(basename "$report")
  if [ ! -e "$golden/$name" ]; then
    echo "$name: no golden report; check the numbers and give --accept"
    status=1
  elif ! kinestat compare "$golden/$name" "$report"; then
    echo "$name: differs"
    status=1
  fi
done
for kept in "$golden"/*.report.json; do
  name=$(basename "$kept")
  if [ ! -e "$reports/$name" ]; then
    echo "$name: no model gives this report; remove it if the model is gone"
    status=1
  fi
done
exit "$status"
