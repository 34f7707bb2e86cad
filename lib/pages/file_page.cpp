#include "pages/file_page.hpp"

#include "core/utf8.hpp"
#include "draw/picture_title.hpp"

namespace kinestat {

std::string page_title(const FilePage& page) {
  const MechanismDescription nameless;
  return printable(shown_name(page.source.path, page.description ? *page.description : nameless));
}

}  // namespace kinestat
