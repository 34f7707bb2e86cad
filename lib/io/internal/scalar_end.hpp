// Where the scalars of a YAML text end, by the rules of yaml-cpp's scanner.
#pragma once

#include <cstddef>

#include "io/internal/yaml_text.hpp"

namespace kinestat {

enum class Context { block, in_brackets };

struct ScalarEnd {
  std::size_t offset = 0;  ///< behind the scalar, white space included that belongs to no token
  bool is_at_tab = false;  ///< it ends because a tab stands in its indentation, at `offset`
};

/// Whether a plain scalar may begin with the character at the offset.
bool is_plain_start(const YamlText& text, std::size_t at, Context context);

/// The end of an anchor, alias or tag.
std::size_t find_name_end(const YamlText& text, std::size_t begin);

/// The offset behind the quote that closes the one at `begin`, or npos; a document mark at the
/// beginning of a line ends the search.
std::size_t find_quote_end(const YamlText& text, std::size_t begin);

/// The end of a plain scalar; it goes on over lines that begin in column `indent` (bytes, from 0)
/// or behind.
ScalarEnd find_plain_end(const YamlText& text, std::size_t begin, int indent, Context context);

/// The end of a block scalar whose sign '|' or '>' stands at `begin`, inside a block whose entries
/// begin in column `block_column`.
ScalarEnd find_block_scalar_end(const YamlText& text, std::size_t begin, int block_column);

}  // namespace kinestat
