// A writer of HTML elements, which escapes what it is given.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kinestat {

/// Writes elements one after the other; those that are open nest. Names of elements and attributes
/// are ours, all else may be anything.
class Html {
 public:
  /// An attribute with an empty value stands without one, as `hidden` does.
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

  void open(std::string_view name, Attributes attributes = {});

  /// Closes the innermost element that is open.
  void close();

  /// An element that contains nothing but text.
  void element(std::string_view name, std::string_view text, Attributes attributes = {});

  /// An element that has no end, such as `input`.
  void single(std::string_view name, Attributes attributes = {});

  void text(std::string_view text);

  /// Text whose line feeds count, for `pre`.
  void lines(std::string_view text);

  /// Markup as it is: pictures, style, script.
  void markup(std::string_view markup) { html_ += markup; }

  /// All elements so far; every one must be closed.
  const std::string& html() const;

 private:
  void begin(std::string_view name, Attributes attributes);

  std::string html_;
  std::vector<std::string> open_;
};

/// JSON that may stand in an element `script`: every "<" as an escape, which changes no value.
std::string script_json(std::string_view json);

/// A text as a JSON string that may stand in an element `script`.
std::string script_string(std::string_view text);

}  // namespace kinestat
