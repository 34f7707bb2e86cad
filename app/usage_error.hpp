// What is wrong with a command line, in the words of this program.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "files/outcome.hpp"

namespace kinestat::app {

/// A value that an option does not take.
class WrongValue : public CLI::ParseError {
 public:
  WrongValue(const std::string& option,
             const std::string& value,
             const std::vector<std::string>& words);
  WrongValue(const std::string& option, const std::string& value, std::string hint);

  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// An option at the end, or before another option, without the value that it takes.
class MissingValue : public CLI::ParseError {
 public:
  explicit MissingValue(const std::string& option);
};

/// An option without another one that it needs.
class LonelyOption : public CLI::ParseError {
 public:
  LonelyOption(const std::string& option, const std::string& needed, std::string hint);

  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Two options of which each says that the other is not meant.
class ForeignOption : public CLI::ParseError {
 public:
  ForeignOption(const std::string& option, const std::string& other, std::string hint);

  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// The message and the status 2; texts of the parser itself are never shown. `words` are those that
/// were parsed.
Outcome usage_error(const CLI::ParseError& problem,
                    const CLI::App& app,
                    const std::vector<std::string>& words);

}  // namespace kinestat::app
