# Completion of kinestat for fish: kinestat completion fish | source
function __kinestat_candidates
    set -l words (commandline --tokenize --cut-at-cursor --current-process)
    set -l typed (commandline --current-token --cut-at-cursor)
    set -l answer ($words[1] completion candidates -- $words[2..-1] "$typed" 2>/dev/null)
    switch "$answer[1]"
        case files
            __fish_complete_path "$typed"
        case folders
            __fish_complete_directories "$typed"
    end
    test (count $answer) -gt 1; and printf '%s\n' $answer[2..-1]
end
complete --command kinestat --no-files --arguments '(__kinestat_candidates)'
