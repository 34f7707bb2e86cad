// Lines and tables of a report as elements of a page.
#pragma once

#include <string_view>

#include "pages/html.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// Where tables stand: on the page, or beside the first picture, where fewer rows have room.
enum class TablePlace { page, beside_picture };

/// A table in a box of its own, in which it scrolls where it is wider or longer than the page has
/// room for; a long one can be folded. Its first column heads the rows. `name` tells what it is.
void add_table(const Table& table,
               std::string_view name,
               Html& html,
               TablePlace place = TablePlace::page);

/// Blocks one below the other; every line is a paragraph.
void add_blocks(const TextBlocks& blocks,
                std::string_view name,
                Html& html,
                TablePlace place = TablePlace::page);

}  // namespace kinestat
