# Writes the versions of CHANGELOG.md that have a date as the changelog of a Debian package.
# awk -v package=NAME -v maintainer='NAME <ADDRESS>' -f changelog.awk CHANGELOG.md
function end_item(    words, count, i, line) {
  count = split(item, words, " ")
  item = ""
  line = "  *"
  for (i = 1; i <= count; ++i) {
    if (length(line) + 1 + length(words[i]) > 78) {
      print line
      line = "   "
    }
    line = line " " words[i]
  }
  if (count) print line
}
function end_version() {
  end_item()
  if (date) printf "\n -- %s  %s\n\n", maintainer, date
  date = ""
}
/^## / {
  end_version()
  if ($3 == "-") {
    command = "date --utc --rfc-email --date=" $4
    if ((command | getline date) <= 0) {
      printf "changelog.awk: %s:%d: \"%s\" is no date that GNU date reads; write 2026-01-31\n", \
        FILENAME, FNR, $4 > "/dev/stderr"
      failed = 1
      exit 1
    }
    close(command)
    printf "%s (%s) unstable; urgency=medium\n", package, $2
  }
  next
}
!date { next }
/^### / {
  end_item()
  printf "\n  [ %s ]\n", substr($0, 5)
  next
}
/^- / { end_item() }
{
  sub(/^- /, "")
  item = item " " $0
}
END { if (!failed) end_version() }
