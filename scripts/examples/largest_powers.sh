#!/usr/bin/env bash
# Where the most power flows in each case of many mechanism files, as one table.
#
#   scripts/examples/largest_powers.sh mechanisms/transmissions/*.yaml > powers.csv
#
# A loop over files: each is analysed by itself, so that one that is wrong leaves the others alone.
# Its messages are on standard error; the exit status is 1 if any file failed.
set -u
status=0
echo "file,case,coupling,power [W]"
for file in "$@"; do
  # A tidy table: mechanism,case,pass,element,quantity,value,unit,status. The title of a mechanism
  # is free text, so columns are counted from the end.
  table=$(kinestat analyze --format csv "$file") || status=1
  awk -F, -v file="$(basename "$file" .yaml)" '
    NF >= 8 && $(NF - 5) == "power" && $(NF - 3) == "into_head" && $(NF - 2) != "" {
      size = $(NF - 2) < 0 ? -$(NF - 2) : $(NF - 2)
      name = $(NF - 6)
      if (!(name in largest)) { order[++count] = name; largest[name] = -1 }
      # Rounding does not decide between couplings that carry the same.
      if (size > largest[name] * (1 + 1e-9)) { largest[name] = size; coupling[name] = $(NF - 4) }
    }
    END {
      for (i = 1; i <= count; ++i) {
        name = order[i]
        printf "%s,%s,%s,%.6g\n", file, name, coupling[name], largest[name]
      }
    }' <<< "$table"
done
exit "$status"
