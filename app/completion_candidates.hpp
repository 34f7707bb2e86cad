// What may stand where the words of a command line end.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace kinestat::app {

struct Candidate {
  std::string word;
  std::string meaning;  ///< a few words, or nothing
};

enum class PathKind { none, files, folders };

struct CompletionCandidates {
  std::vector<Candidate> words;
  PathKind paths = PathKind::none;  ///< what of the file system may stand there as well
};

/// The words that continue the last of `words`, which may be empty; those before it are behind the
/// program's name. Names of cases, actuators and parameters are those of the first file among them.
CompletionCandidates completion_candidates(const CLI::App& app, std::span<const std::string> words);

}  // namespace kinestat::app
