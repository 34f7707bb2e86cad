#!/usr/bin/env bash
# Shows what an editor offers for a mechanism file, and fails if anything is missing.
#
# Editors with the YAML language server (VS Code with the extension "YAML" by Red Hat, Neovim,
# Emacs, Helix, Zed and others) read the first line of a mechanism file,
#   # yaml-language-server: $schema=../../schemas/mechanism.schema.json
# and then complete keys and words, explain the key under the pointer, and underline mistakes. This
# script starts that server as an editor would, opens files of mechanisms/ and prints what the editor
# shows: completion in a coupling, in a case and at the top level, hover, and the messages for a file
# with mistakes. It is not needed to build or use kinestat.
#
# Usage: scripts/show_editor_support.sh [FOLDER]
#   FOLDER  where the server is installed and kept for the next time; default a temporary folder
# Needs node and npm; the server comes from the npm registry. Exit status: 0 all is there, 1
# something is missing, 4 the server cannot be installed.
set -euo pipefail

server=yaml-language-server@1.25.0

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

stop() {
  printf 'show_editor_support.sh: %s\n' "$@" >&2
  exit 4
}

case ${1:-} in
  -*)
    printf 'usage: scripts/show_editor_support.sh [FOLDER]\n' >&2
    exit 2
    ;;
esac
for command in node npm; do
  command -v "$command" >/dev/null ||
    stop "$command is missing; in Debian: apt-get install nodejs npm"
done

folder=${1:-}
if [[ -z $folder ]]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
fi
program=$folder/node_modules/yaml-language-server/bin/yaml-language-server
if [[ ! -f $program ]]; then
  npm install --prefix "$folder" --no-audit --no-fund --no-save --loglevel=error "$server" >&2 ||
    stop "could not install $server into $folder"
fi

node "$root/scripts/editor_support.mjs" "$program" "$root"
