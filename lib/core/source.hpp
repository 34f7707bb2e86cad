// A place in a text file, and the text itself.
#pragma once

#include <string>

namespace kinestat {

/// A stretch of one line. Lines and columns count from 1; columns and lengths count characters
/// (Unicode code points), as editors do. Line 0 means the whole file.
struct SourceRange {
  int line = 0;
  int column = 0;
  int length = 0;

  friend bool operator==(const SourceRange&, const SourceRange&) = default;
};

/// A file as it was read: the path as the user gave it ("-" is standard input) and its bytes.
struct SourceFile {
  std::string path;
  std::string text;
};

}  // namespace kinestat
