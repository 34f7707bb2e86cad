// What a page says of one file: summary, findings, passes, data.
#pragma once

#include <string>
#include <vector>

#include "plot/file_page.hpp"
#include "plot/page/html.hpp"

namespace kinestat {

/// A heading for the table of contents.
struct PageHeading {
  std::string id;
  std::string title;
};

/// Whether the title of the page is that of its only file.
enum class PageForm { one_file, many_files };

/// Adds the section of a file and gives its headings. Ids begin with `id`; the figures are
/// numbered on from `figures`.
std::vector<PageHeading> add_file_section(
    const FilePage& page, const std::string& id, PageForm form, int& figures, Html& html);

}  // namespace kinestat
