// A page in one file: everything that is known of some mechanisms, in words, tables and pictures.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pages/file_page.hpp"

namespace kinestat {

/// What every page of this program begins with; a file that begins otherwise is foreign.
std::string_view html_signature();

/// The whole page, the same bytes for the same files. It loads nothing, runs no script but its own,
/// and is complete without one.
std::string html_report(std::span<const FilePage> pages);

}  // namespace kinestat
