// Lines and tables of a report as elements of a page.
#pragma once

#include <string_view>

#include "pages/html.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// A table in a box of its own, in which it scrolls where it is wider or longer than the page has
/// room for; a long one can be folded. Its first column heads the rows. `name` tells what it is.
void add_table(const Table& table, std::string_view name, Html& html);

/// Blocks one below the other; every line is a paragraph.
void add_blocks(const TextBlocks& blocks, std::string_view name, Html& html);

}  // namespace kinestat
