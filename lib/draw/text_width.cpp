#include "draw/text_width.hpp"

#include <algorithm>
#include <array>

#include "core/utf8.hpp"
#include "draw/markup.hpp"

namespace kinestat {

namespace {

// Advance widths of ' ' to '~' in thousandths of the size: the larger of Helvetica, whose metrics
// Arial and Liberation share, and DejaVu Sans.
constexpr std::array<int, 95> kNormal = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 556, 1015, 684, 686, 722, 770, 667,
    611, 778, 752, 295, 500, 667, 557, 863, 748, 787, 667, 787, 722, 667,  611, 732, 684, 989, 685,
    667, 685, 390, 337, 390, 838, 556, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};

constexpr std::array<int, 95> kBold = {
    348,  456, 521, 838, 696, 1002, 872, 306,  457, 457, 523, 838, 380, 415,  380, 365,
    696,  696, 696, 696, 696, 696,  696, 696,  696, 696, 400, 400, 838, 838,  838, 611,
    1015, 774, 762, 734, 830, 683,  683, 821,  837, 372, 556, 775, 637, 995,  837, 850,
    778,  850, 770, 720, 682, 812,  774, 1103, 771, 724, 725, 457, 365, 457,  838, 556,
    500,  675, 716, 593, 716, 678,  435, 716,  712, 343, 343, 665, 343, 1042, 712, 687,
    716,  716, 493, 595, 478, 712,  652, 924,  645, 652, 582, 712, 365, 712,  838};

double character_width(char32_t code, Weight weight) {
  if (code >= U' ' && code <= U'~') {
    const std::size_t at = code - U' ';
    return (weight == Weight::bold ? kBold : kNormal)[at] / 1000.0;
  }
  const bool is_combining = code >= 0x300 && code < 0x370;
  if (is_combining) {
    return 0.0;
  }
  // Latin and Greek letters are at most as wide as ω; mathematical signs, 'Œ' and ideographs 1.
  const bool is_letter = (code >= 0xC0 && code < 0x3FF && code != 0x152);
  return is_letter ? 0.87 : 1.0;
}

bool is_inside_character(std::string_view text, std::size_t at) {
  return at < text.size() && !begins_character(text[at]);
}

}  // namespace

double text_width(std::string_view text, double size, Weight weight) {
  double width = 0.0;
  for (const char32_t code : code_points(text)) {
    width += character_width(code, weight);
  }
  return width * size;
}

std::string fitting_text(std::string_view text, double size, double width, Weight weight) {
  if (text_width(text, size, weight) <= width) {
    return std::string(text);
  }
  const std::string dots = "…";
  const auto cut = [&](std::size_t length) {
    while (length > 0 && is_inside_character(text, length)) {
      --length;
    }
    return std::string(text.substr(0, length)) + dots;
  };
  // Longer texts are wider, so that halving finds the longest that fits.
  std::size_t fits = 0;
  std::size_t too_long = text.size();
  while (too_long - fits > 1) {
    const std::size_t middle = fits + (too_long - fits) / 2;
    (text_width(cut(middle), size, weight) <= width ? fits : too_long) = middle;
  }
  return cut(fits);
}

std::vector<std::string> wrapped_text(std::string_view text,
                                      double size,
                                      double width,
                                      Weight weight) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = fitting_text(text.substr(at, end - at), size, width, weight);
    at = end + 1;
    if (word.empty()) {
      continue;
    }
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && text_width(longer, size, weight) <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace kinestat
