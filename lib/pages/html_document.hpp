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

/// The only style of a page: the palette of the pictures, light and dark, and its own rules.
std::string page_style();

/// The only script, as far as it works on what the page shows.
std::string page_script(std::string_view content);

/// The content security policy: nothing is loaded from anywhere; of style and script only those
/// with these texts count.
std::string content_policy(std::string_view style, std::string_view script);

}  // namespace kinestat
