#include "plot/file_page.hpp"

#include "core/utf8.hpp"

namespace kinestat {

std::string page_title(const FilePage& page) {
  if (page.description && !page.description->name.empty()) {
    return printable(page.description->name);
  }
  return page.source.path == "-" ? "<stdin>" : printable(page.source.path);
}

}  // namespace kinestat
