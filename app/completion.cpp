#include <fmt/format.h>

#include "command.hpp"
#include "completion_candidates.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"

namespace kinestat::app {

namespace {

// In place of a shell: with it the scripts ask the program itself for what may follow, as in
// `kinestat completion candidates -- WORD...`, the last word being the one that is typed.
constexpr std::string_view kCandidates = "candidates";

// What the scripts ask for: a line that says which paths fit, then a candidate a line, its meaning
// behind a tab.
std::string lines_of(const CompletionCandidates& candidates) {
  std::string text = candidates.paths == PathKind::files     ? "files\n"
                     : candidates.paths == PathKind::folders ? "folders\n"
                                                             : "words\n";
  for (const Candidate& one : candidates.words) {
    text += one.word + (one.meaning.empty() ? "" : "\t" + one.meaning) + "\n";
  }
  return text;
}

Outcome script_for(const std::string& shell, const std::vector<std::string>& more) {
  Outcome outcome;
  if (!more.empty()) {
    add_message("E0101",
                fmt::format("unexpected word '{}'", printable(more.front())),
                "one shell at a time",
                outcome);
    return outcome;
  }
  if (const EmbeddedText* script = find_text(embedded_completions(), shell)) {
    outcome.out = script->text;
    return outcome;
  }
  add_message("E0101",
              fmt::format("there is no completion for '{}'", printable(shell)),
              fmt::format("shells are {}", plain_list(names_of(embedded_completions()))),
              outcome);
  return outcome;
}

struct Completion {
  std::string shell;
  std::vector<std::string> words;
};

}  // namespace

void add_completion(CLI::App& command, Job& job) {
  command.footer(
      "  source <(kinestat completion bash)\n"
      "  kinestat completion zsh > ~/.zfunc/_kinestat\n"
      "  # in ~/.zshrc, before compinit: fpath+=(~/.zfunc)\n"
      "  kinestat completion fish | source\n");
  auto completion = std::make_shared<Completion>();
  add_argument(command, "SHELL", completion->shell, "bash, zsh or fish").required();
  // Behind the word `candidates`, for the scripts alone.
  add_argument(command, "WORDS", completion->words, "").group("");
  run_when_chosen(command, job, [completion, &command]() -> Outcome {
    if (completion->shell == kCandidates) {
      return {.out = lines_of(completion_candidates(*command.get_parent(), completion->words)),
              .err = {}};
    }
    return script_for(completion->shell, completion->words);
  });
}

}  // namespace kinestat::app
