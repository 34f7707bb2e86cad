# Completion of kinestat for fish: kinestat completion fish | source
function __kinestat_answer
    set -l words (commandline --tokenize --cut-at-cursor --current-process | string replace --regex '^~(?=/)' $HOME)
    set -l token (commandline --current-token --cut-at-cursor)
    set -l typed (string unescape -- $token; or string trim --left --chars '"\'' -- $token)
    $words[1] completion candidates -- $words[2..-1] "$typed" 2>/dev/null
end
function __kinestat_candidates
    set -l answer (__kinestat_answer)
    switch "$answer[1]"
        case folders
            __fish_complete_directories (commandline --current-token --cut-at-cursor)
    end
    test (count $answer) -gt 1; and printf '%s\n' $answer[2..-1]
end
complete --command kinestat --no-files --arguments '(__kinestat_candidates)'
complete --command kinestat --condition 'test (__kinestat_answer)[1] = files' --force-files
