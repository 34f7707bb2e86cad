#!/usr/bin/env bash
# Installs the Debian packages that are missing; does nothing if all are installed.
# Usage: scripts/setup.sh [build|package|test|sanitize|bench|lint|browser|viewers|manual]...   (default: build test)
set -euo pipefail

build=(g++ cmake ninja-build ccache pkg-config libeigen3-dev libyaml-cpp-dev libcli11-dev
  libfmt-dev libdragonbox-dev nlohmann-json3-dev libboost-dev libgmp-dev libmpfr-dev
  libxxhash-dev libmd-dev libutf8proc-dev)
package=("${build[@]}" dpkg-dev file)  # to find what the library needs
test=("${package[@]}" libgtest-dev python3 python3-jsonschema python3-yaml)
sanitize=("${test[@]}" clang libclang-rt-14-dev)
bench=("${build[@]}" liblapack-dev libblas-dev libsuitesparse-dev)
lint=(clang-format clang-tidy)
browser=(chromium chromium-driver)
viewers=(graphviz gnuplot-nox groff-base zsh fish valgrind)
manual=(python3 python3-yaml python3-sphinx python3-myst-parser furo fonts-stix)

stop() {
  local status=$1
  shift
  printf 'setup.sh: %s\n' "$@" >&2
  exit "$status"
}

# Ends the script. The checker of accessibility is not in Debian; without it its tests are skipped.
finish() {
  local root
  if [[ -n $checks ]] && command -v npm >/dev/null && root=$(npm root --global 2>/dev/null) &&
    [[ ! -e $root/axe-core/axe.min.js ]]; then
    echo "setup.sh: installing axe-core by npm" >&2
    "$@" npm install --global --no-fund --no-audit axe-core >/dev/null 2>&1 </dev/null ||
      echo "setup.sh: npm could not install axe-core, so tests of accessibility are skipped" >&2
  fi
  exit 0
}

checks=
wanted=()
[[ $# -gt 0 ]] || set -- build test
for part in "$@"; do
  case $part in
    build) wanted+=("${build[@]}") ;;
    package) wanted+=("${package[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    sanitize) wanted+=("${sanitize[@]}") ;;
    bench) wanted+=("${bench[@]}") ;;
    lint) wanted+=("${lint[@]}") ;;
    browser) wanted+=("${browser[@]}") checks=yes ;;
    viewers) wanted+=("${viewers[@]}") ;;
    manual) wanted+=("${manual[@]}") ;;
    *) stop 2 "unknown part '$part'; parts are build, package, test, sanitize, bench, lint, browser, viewers, manual" ;;
  esac
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  stop 4 "this is not a Debian system, so nothing was installed" \
    "needed (names as in Debian 12): ${wanted[*]}" \
    "with these in place, build by hand: cmake --preset release && cmake --build --preset release"
fi

# One query for all; a package that dpkg has never heard of is simply not listed.
installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done

as_root=(env DEBIAN_FRONTEND=noninteractive)
if [[ $(id -u) -ne 0 ]]; then
  if [[ ${#missing[@]} -eq 0 ]] && ! command -v sudo >/dev/null; then
    finish env
  fi
  command -v sudo >/dev/null ||
    stop 4 "these packages are missing, and installing needs root or sudo: ${missing[*]}" \
      "as root: apt-get install --no-install-recommends ${missing[*]}"
  as_root=(sudo "${as_root[@]}")
fi
[[ ${#missing[@]} -gt 0 ]] || finish "${as_root[@]}"

echo "setup.sh: installing ${missing[*]}" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
{ "${as_root[@]}" apt-get update && "${as_root[@]}" apt-get install -y --no-install-recommends \
  "${missing[@]}"; } >"$log" 2>&1 </dev/null || {
  cat "$log" >&2
  stop 4 "could not install ${missing[*]}"
}
finish "${as_root[@]}"
