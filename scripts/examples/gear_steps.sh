#!/usr/bin/env bash
# The trains of a sweep with the steps between their gears, the smallest spread of steps first.
#
#   scripts/examples/gear_steps.sh mechanisms/sweeps/ravigneaux_search.yaml | head
#
# A sweep has one row a train and gear. It is piped through the usual tools: awk puts the gears of a
# train on one line and divides their ratios, sort ranks them. Nothing is kept but one train at a
# time, so the sweep may be as long as it likes.
set -euo pipefail
kinestat sweep --quiet "$1" |
  awk -F, '
    NR == 1 {
      for (i = 1; i <= NF; ++i) column[$i] = i
      parameters = column["case"] - 1
      next
    }
    $column["status"] == "solved" {
      train = $1
      for (i = 2; i <= parameters; ++i) train = train "," $i
      if (train != last) { finish(); last = train; count = 0 }
      ratio[++count] = $column["ratio"]
    }
    function finish(    i, line, step) {
      if (count < 2) return
      line = ratio[1]
      for (i = 2; i <= count; ++i) line = line "," ratio[i]
      step = ratio[1] / ratio[2]
      printf "%.6f,%s,%s\n", step, last, line
    }
    END { finish() }' |
  sort -t, -k1,1g
