#compdef kinestat
# Completion of kinestat for zsh: as _kinestat in a folder of $fpath, or sourced after compinit.
_kinestat() {
  local -a given answer candidates open
  local line
  given=("${(@Q)words[1,CURRENT-1]}" "${(Q)PREFIX}")
  given=("${(@)given/#\~\//$HOME/}")
  answer=("${(@f)$(${given[1]} completion candidates -- "${(@)given[2,-1]}" 2>/dev/null)}")
  case ${answer[1]} in
    files) compset -P '--*='; _files ;;
    folders) compset -P '--*='; _files -/ ;;
  esac
  for line in "${(@)answer[2,-1]}"; do
    [[ -n $line ]] || continue
    line=${${line//\\/\\\\}//:/\\:}
    line=${line/$'\t'/:}
    [[ $line == *= ]] && open+=("$line") || candidates+=("$line")
  done
  (( ${#candidates} )) && _describe -V kinestat candidates
  (( ${#open} )) && _describe -V kinestat open -S ''
}
if [[ $funcstack[1] == _kinestat ]]; then
  _kinestat "$@"
else
  compdef _kinestat kinestat
fi
