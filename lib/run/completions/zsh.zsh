#compdef kinestat
# Completion of kinestat for zsh: as _kinestat in a folder of $fpath, or sourced after compinit.
_kinestat() {
  local -a answer candidates
  local line
  answer=("${(@f)$(${words[1]} completion candidates -- "${(@Q)words[2,CURRENT-1]}" \
    "${(Q)PREFIX}" 2>/dev/null)}")
  case ${answer[1]} in
    files) _files ;;
    folders) _files -/ ;;
  esac
  for line in "${(@)answer[2,-1]}"; do
    [[ -n $line ]] || continue
    line=${line//:/\\:}
    candidates+=("${line/$'\t'/:}")
  done
  (( ${#candidates} )) && _describe -V kinestat candidates
}
if [[ $funcstack[1] == _kinestat ]]; then
  _kinestat "$@"
else
  compdef _kinestat kinestat
fi
