// Values as they are written to a mechanism file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kinestat {

/// A single value, a list or a mapping, each value as it stands in the file.
struct FileText {
  enum class Kind { single, list, mapping };

  Kind kind = Kind::single;
  std::string single = {};
  std::vector<FileText> items = {};
  std::vector<std::pair<std::string, FileText>> entries = {};
  bool in_lines = false;  ///< a line for each entry
};

FileText single_text(std::string text);

/// In quotes where the commas, brackets or other marks of the expression would end it.
FileText expression_text(std::string_view expression);

FileText list_text(std::vector<FileText> items);

/// A text between double quotes, so that nothing in it has a meaning of its own.
std::string in_quotes(std::string_view text);

/// The value behind "key:", with the space or the lines between.
std::string behind_key(const FileText& value, int indent);

}  // namespace kinestat
