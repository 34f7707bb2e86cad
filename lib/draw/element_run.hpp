// Elements of a picture that may be written as one.
#pragma once

#include <cstddef>
#include <string>

namespace kinestat {

/// Those of one kind and style at the end of what is written: a path takes lines or areas, a group
/// texts.
struct ElementRun {
  enum class Kind { none, lines, areas, texts };

  Kind kind = Kind::none;
  std::string style;  ///< attributes
  std::string first;  ///< what of the first would be in the whole
  std::size_t begin = 0;
  std::size_t end = 0;
  bool is_whole = false;  ///< several have been joined
};

}  // namespace kinestat
