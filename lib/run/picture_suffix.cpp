#include "run/picture_suffix.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "files/each_file.hpp"

namespace kinestat {

namespace {

// Pictures of dots and pages, which are made of the SVG by a program that has fonts.
struct ForeignForm {
  std::string_view suffix;
  std::string_view by;  ///< what makes it of an SVG; empty: several programs do
};

constexpr ForeignForm kForeignForms[] = {{"png", "rsvg-convert"},
                                         {"pdf", "rsvg-convert -f pdf"},
                                         {"ps", "rsvg-convert -f ps"},
                                         {"eps", "rsvg-convert -f eps"},
                                         {"jpg", {}},
                                         {"jpeg", {}},
                                         {"gif", {}},
                                         {"webp", {}},
                                         {"tif", {}},
                                         {"tiff", {}},
                                         {"bmp", {}}};

}  // namespace

bool check_picture_suffix(const std::string& file, Outcome& outcome) {
  const std::size_t dot = file.rfind('.');
  if (dot == std::string::npos) {
    return true;
  }
  std::string suffix = file.substr(dot + 1);
  std::ranges::transform(suffix, suffix.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  const auto* const foreign = std::ranges::find(kForeignForms, suffix, &ForeignForm::suffix);
  if (foreign == std::end(kForeignForms)) {
    return true;
  }
  const std::string path = printable(file);
  const std::string svg = printable(file.substr(0, dot)) + ".svg";
  add_message("E0101",
              fmt::format("-o {}: pictures are not written as {}", path, suffix),
              foreign->by.empty()
                  ? fmt::format("write -o {}, which other programs turn into {}", svg, suffix)
                  : fmt::format("write -o {}, then: {} -o {} {}", svg, foreign->by, path, svg),
              outcome);
  return false;
}

}  // namespace kinestat
