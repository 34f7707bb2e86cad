#include "plot/picture.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "plot/markup.hpp"

namespace kinestat {

namespace {

std::string with_ids(const std::string& elements, std::string_view prefix) {
  std::string result;
  result.reserve(elements.size());
  for (const char character : elements) {
    if (character == kIdMark.front()) {
      result += fmt::format("{}-", prefix);
    } else {
      result += character;
    }
  }
  return result;
}

// Everything of the element but the closing bracket of its begin.
std::string opening(const Picture& picture) {
  const PixelBox& view = picture.view;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" width=\"{}\" "
      "height=\"{}\" viewBox=\"{} {} {} {}\" font-family=\"{}\"",
      escape_markup(picture.title),
      format_coordinate(view.width()),
      format_coordinate(view.height()),
      format_coordinate(view.left),
      format_coordinate(view.top),
      format_coordinate(view.width()),
      format_coordinate(view.height()),
      kFontFamily);
}

std::string words(const Picture& picture) {
  return fmt::format("<title>{}</title>\n<desc>{}</desc>\n",
                     escape_markup(picture.title),
                     escape_markup(picture.description));
}

}  // namespace

Picture make_picture(
    std::string name, std::string title, std::string description, const Svg& svg, double margin) {
  KINESTAT_EXPECTS(!svg.bounds().is_empty());
  const PixelBox outer = svg.bounds().grown(margin);
  return {.name = std::move(name),
          .title = std::move(title),
          .description = std::move(description),
          .view = {.left = std::floor(outer.left),
                   .top = std::floor(outer.top),
                   .right = std::ceil(outer.right),
                   .bottom = std::ceil(outer.bottom)},
          .elements = svg.elements()};
}

std::string svg_file(const Picture& picture) {
  Svg paper;
  paper.rectangle(picture.view, {.stroke = Ink::none, .fill = Ink::paper});
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}>\n{}<style>:root{{{}}}"
      "@media (prefers-color-scheme:dark){{:root{{{}}}}}{}</style>\n{}{}</svg>\n",
      opening(picture),
      words(picture),
      light_variables(),
      dark_variables(),
      ink_rules(),
      paper.elements(),
      with_ids(picture.elements, picture.name));
}

std::string svg_element(const Picture& picture, std::string_view prefix) {
  return fmt::format("{} id=\"{}\">\n{}{}</svg>\n",
                     opening(picture),
                     prefix,
                     words(picture),
                     with_ids(picture.elements, prefix));
}

}  // namespace kinestat
