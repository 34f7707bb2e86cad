# Completion of kinestat for bash: source <(kinestat completion bash)
_kinestat() {
  local words=("${COMP_WORDS[@]}") at=$COMP_CWORD typed=${COMP_WORDS[COMP_CWORD]} before=""
  # bash takes --case=M1 and 2:3 apart; bash-completion, where it is loaded, does not.
  if declare -F _get_comp_words_by_ref >/dev/null; then
    local cur="" cword=0
    _get_comp_words_by_ref -n "=:" cur words cword
    at=$cword typed=$cur
  fi
  local answer kind line
  answer=$("${words[0]/#\~/$HOME}" completion candidates -- "${words[@]:1:at-1}" "$typed" \
    2>/dev/null) || return
  kind=${answer%%$'\n'*}
  COMPREPLY=()
  case $kind in
    files) mapfile -t COMPREPLY < <(compgen -f -- "$typed"); compopt -o filenames ;;
    folders) mapfile -t COMPREPLY < <(compgen -d -- "$typed"); compopt -o filenames ;;
  esac
  [[ $typed == *=* && ${COMP_WORDS[COMP_CWORD]} != "$typed" ]] && before=${typed%"${typed#*=}"}
  while IFS= read -r line; do
    line=${line%%$'\t'*}
    [[ -n $line ]] || continue
    [[ $line == *= ]] && compopt -o nospace
    line=${line#"$before"}
    COMPREPLY+=("$(printf '%q' "$line")")
  done < <(tail -n +2 <<<"$answer")
}
complete -F _kinestat kinestat
