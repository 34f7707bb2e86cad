#!/usr/bin/env bash
# Runs every fuzz target that is built for a share of so many minutes: bytes, changed files in one
# process, and changed files through the program.
# Usage: scripts/fuzz.sh MINUTES [--seed S] [--only TARGETS] [--write]
# PROGRAM=… in the environment is another program. What is found is kept in build/found, and each run
# is a line of tests/fuzz/log.jsonl, from which --write makes the table in RELIABILITY.md; exit status
# 1 if anything is found.
set -euo pipefail

exec python3 -B "$(dirname "${BASH_SOURCE[0]}")/../tests/fuzz/campaign.py" "$@"
