// A scalar with its place in the source.
#pragma once

#include <cstddef>
#include <string>

#include "io/internal/source_map.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// The node of a scalar that begins at the offset, behind its anchor, and reads as `value`.
YamlNode make_scalar(SourceMap& map, std::size_t begin, const std::string& value);

/// An escape in a text in double quotes, with its backslash.
struct Escape {
  std::size_t begin = 0;
  std::size_t size = 0;
};

/// The first escape that stands for a control character, or that yaml-cpp does not read as UTF-8;
/// the opening quote, one byte, where none does.
Escape find_bad_escape(const YamlText& text, std::size_t begin);

/// Whether a null is written out at the offset.
bool is_null_word(const YamlText& text, std::size_t at);

}  // namespace kinestat
