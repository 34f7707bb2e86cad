#include "draw/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/markup.hpp"

namespace kinestat {

namespace {

constexpr double kMargin = 12.0;
constexpr double kTitleSize = 15.0;
constexpr double kTitleLine = 20.0;

// Narrower pictures get room for their title at the right.
constexpr double kLeastWidth = 400.0;

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

// Without what the style of a page says by classes: colours, that nothing else is filled, round
// ends, the rim of paper around letters, and that these are of ink. No text holds a quote that
// would look like such an attribute.
std::string without_colours(std::string_view elements) {
  constexpr auto kWhole = std::to_array<std::string_view>(
      {" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
       " fill=\"none\"",
       " stroke-linecap=\"round\" stroke-linejoin=\"round\""});
  constexpr auto kColours = std::to_array<std::string_view>({" fill=\"#", " stroke=\"#"});
  constexpr std::string_view kInk = " class=\"ks-f-ink\"";
  std::string result;
  result.reserve(elements.size());
  bool is_text = false;
  const auto skipped = [&]() -> std::size_t {
    for (const std::string_view whole : kWhole) {
      if (elements.starts_with(whole)) {
        return whole.size();
      }
    }
    for (const std::string_view begin : kColours) {
      if (elements.starts_with(begin)) {
        return elements.find('"', begin.size()) + 1;
      }
    }
    return is_text && elements.starts_with(kInk) ? kInk.size() : 0;
  };
  while (!elements.empty()) {
    if (const std::size_t size = skipped(); size > 0) {
      elements.remove_prefix(size);
      continue;
    }
    const std::size_t next = std::min(elements.find(' ', 1), elements.size());
    const std::string_view word = elements.substr(0, next);
    if (const std::size_t tag = word.rfind('<'); tag != std::string_view::npos) {
      is_text = word.substr(tag) == "<text" || word.substr(tag) == "<g";
    }
    result += word;
    elements.remove_prefix(next);
  }
  return result;
}

// Everything of the element but the closing bracket of its begin; a file says more.
std::string opening(const Picture& picture, std::string_view more = {}) {
  const PixelBox& view = picture.view;
  return fmt::format(
      "<svg{} role=\"img\" aria-label=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\"",
      more,
      escape_markup(picture.title),
      format_coordinate(view.width()),
      format_coordinate(view.height()),
      format_coordinate(view.left),
      format_coordinate(view.top),
      format_coordinate(view.width()),
      format_coordinate(view.height()));
}

std::string words(const Picture& picture) {
  return fmt::format("<title>{}</title>\n<desc>{}</desc>\n",
                     escape_markup(picture.title),
                     escape_markup(picture.description));
}

// The picture with its title above what it shows, in as many lines as its width asks for.
Picture with_title(const Picture& picture) {
  Picture whole = picture;
  const double left = picture.view.left + kMargin;
  const double width = std::max(picture.view.width(), kLeastWidth) - 2 * kMargin;
  const std::vector<std::string> lines =
      wrapped_text(picture.title, kTitleSize, width, Weight::bold);
  Svg svg;
  double y = picture.view.top - kTitleLine * static_cast<double>(lines.size());
  whole.view.top = std::floor(y - kMargin);
  for (const std::string& line : lines) {
    y += kTitleLine;
    svg.text(
        {.x = left, .y = y - kTitleLine / 4}, line, {.size = kTitleSize, .weight = Weight::bold});
  }
  whole.view.right = std::max(whole.view.right, std::ceil(svg.bounds().right + kMargin));
  whole.elements = svg.elements() + picture.elements;
  return whole;
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

std::string_view svg_signature() {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- kinestat picture -->\n";
}

std::string svg_file(const Picture& picture) {
  const Picture whole = with_title(picture);
  Svg paper;
  paper.rectangle(whole.view, {.stroke = Ink::none, .fill = Ink::paper});
  return fmt::format(
      "{}{}>\n{}<style>:root{{{}}}"
      "@media (prefers-color-scheme:dark){{:root{{{}}}}}{}</style>\n{}{}</svg>\n",
      svg_signature(),
      opening(whole,
              fmt::format(" xmlns=\"http://www.w3.org/2000/svg\" font-family=\"{}\"", kFontFamily)),
      words(whole),
      light_variables(),
      dark_variables(),
      ink_rules(),
      paper.elements(),
      with_ids(whole.elements, whole.name));
}

std::string svg_element(const Picture& picture, std::string_view prefix) {
  return fmt::format("{} id=\"{}\">\n{}{}</svg>\n",
                     opening(picture),
                     prefix,
                     words(picture),
                     without_colours(with_ids(picture.elements, prefix)));
}

}  // namespace kinestat
