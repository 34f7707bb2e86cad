# Completion of kinestat for bash: source <(kinestat completion bash)
_kinestat() {
  local words=() line=${COMP_LINE:0:COMP_POINT} last=${COMP_WORDS[COMP_CWORD]} word raw
  # bash takes --case=M1 and 2:3 apart: what has no blank between is one word.
  for word in "${COMP_WORDS[@]:0:COMP_CWORD}" ""; do
    if [[ ${#words[@]} -gt 0 && $line != [[:blank:]]* ]]; then
      words[-1]+=$word
    else
      words+=("$word")
    fi
    line=${line#"${line%%[![:blank:]]*}"}
    line=${line#"$word"}
  done
  words[-1]+=$line raw=${words[-1]}
  [[ $last == [=:] ]] && last=""
  [[ $raw == *"$last" ]] || last=${raw##*[=:]}  # the cursor stands within the word
  local at before=${raw%"$last"} answer kind
  for at in "${!words[@]}"; do  # the program sees words as the shell would give them
    word=${words[at]//[\"\'\\]/}
    words[at]=${word/#\~\//$HOME/}
  done
  answer=$("${words[0]}" completion candidates -- "${words[@]:1}" 2>/dev/null) || return
  kind=${answer%%$'\n'*}
  COMPREPLY=()
  case $kind in
    files) mapfile -t COMPREPLY < <(compgen -f -- "${raw#"$before"}"); compopt -o filenames ;;
    folders) mapfile -t COMPREPLY < <(compgen -d -- "${raw#"$before"}"); compopt -o filenames ;;
  esac
  while IFS= read -r line; do
    line=${line%%$'\t'*}
    [[ $line == *= ]] && compopt -o nospace
    line=${line#"$before"}
    [[ -n $line ]] || continue
    [[ $last == [\"\']* ]] || line=$(printf '%q' "$line")
    COMPREPLY+=("$line")
  done < <(tail -n +2 <<<"$answer")
}
complete -F _kinestat kinestat
