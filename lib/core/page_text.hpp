// Lines of pages of help.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kinestat {

/// The columns of a page.
inline constexpr std::size_t kPageWidth = 80;

/// The words in lines that fit a page, each ended; they begin in the column `begin`. `head` stands
/// in front of the first line.
std::string page_lines(std::string_view head,
                       std::string_view words,
                       std::size_t begin,
                       std::size_t width = kPageWidth);

}  // namespace kinestat
