// What a page says of one file: summary, findings, passes, data.
#pragma once

#include <string>
#include <vector>

#include "pages/file_page.hpp"
#include "pages/html.hpp"
#include "pages/section_writer.hpp"

namespace kinestat {

/// Adds the section of a file and gives its headings. Ids begin with `id`; the figures are
/// numbered on from `figures`.
std::vector<PageHeading> add_file_section(
    const FilePage& page, const std::string& id, PageForm form, int& figures, Html& html);

}  // namespace kinestat
