// What the program has to say about an input: place, code, cause and what to type instead.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/source.hpp"

namespace kinestat {

enum class Severity { error, warning };

/// A second place that explains the first ("first declared here").
struct Note {
  SourceRange where;
  std::string message;
};

/// One message. `code` is a row of core/codes. The message is lower case, without a full stop, with
/// the user's names in single quotes; the hint says what to do.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string_view code;
  SourceRange where;
  std::string message;
  std::string hint;
  std::vector<Note> notes;
};

/// Collects the messages of one file, in the order in which they were found. Messages and hints may
/// quote the file as it stands: they are kept as one line of printable text, in which any other
/// character stands as \xNN. Notes are the program's own words.
class Diagnostics {
 public:
  /// Adds an error. `code` must be a literal that core/codes lists.
  Diagnostic& error(std::string_view code,
                    SourceRange where,
                    std::string message,
                    std::string hint = {});

  /// Adds a warning, with a W code.
  Diagnostic& warning(std::string_view code,
                      SourceRange where,
                      std::string message,
                      std::string hint = {});

  bool has_errors() const { return error_count_ > 0; }

  int error_count() const { return error_count_; }

  /// Whether a further error has a chance to be read. A hint that costs a search among many names
  /// may be left out otherwise, so that a file full of mistakes is answered at once.
  bool is_hint_worth_it() const { return error_count_ < kMostHints; }

  /// Makes room for that many more at once, where many are known to come.
  void reserve(std::size_t more) { items_.reserve(items_.size() + more); }

  std::span<const Diagnostic> items() const { return items_; }

 private:
  Diagnostic& add(Diagnostic one);

  static constexpr int kMostHints = 100;

  std::vector<Diagnostic> items_;
  int error_count_ = 0;
};

}  // namespace kinestat
