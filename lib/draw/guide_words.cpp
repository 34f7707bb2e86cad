#include "draw/guide_words.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "draw/svg.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostWords = 40;
constexpr double kRim = 12.0;    // of the picture beside the frame [px]
constexpr double kBeside = 4.0;  // from a guide to the words that begin or end there [px]
constexpr TextStyle kGuideStyle = {.size = kTickText, .has_halo = true};

TextStyle style_of(Anchor anchor) {
  TextStyle style = kGuideStyle;
  style.anchor = anchor;
  return style;
}

double place_of(double x, Anchor anchor) {
  return anchor == Anchor::start ? x + kBeside : anchor == Anchor::end ? x - kBeside : x;
}

}  // namespace

double GuideWords::Words::left() const {
  const double place = place_of(x, anchor);
  return anchor == Anchor::start ? place : place - (anchor == Anchor::end ? width : width / 2);
}

GuideWords::GuideWords(std::span<const ChartGuide> guides, const ChartFrame& frame)
    : guides_(guides) {
  for (const ChartGuide& guide : guides.first(std::min(guides.size(), kMostWords))) {
    if (!guide.is_named) {
      break;
    }
    words_.push_back({.text = guide.label,
                      .x = frame.place(guide.x, frame.y.low).x,
                      .width = text_width(guide.label, kTickText),
                      .anchor = Anchor::middle,
                      .row = -1});
  }
  lay_out(frame);
  if (!has_room(frame)) {
    is_numbered_ = true;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      words_[i].text = std::to_string(i + 1);
      words_[i].width = text_width(words_[i].text, kTickText);
      words_[i].row = -1;
    }
    lay_out(frame);
  }
}

void GuideWords::lay_out(const ChartFrame& frame) {
  for (Words& one : words_) {
    one.anchor = Anchor::middle;
  }
  turn_inwards(frame);
  for (std::size_t i = 0; i < words_.size(); ++i) {
    find_row(i, 0);
  }
}

bool GuideWords::has_room(const ChartFrame& frame) const {
  constexpr double kAxis = 50.0;  // of its numbers and title, beside the frame [px]
  return std::ranges::all_of(words_, [&](const Words& one) {
    return one.left() >= frame.box.left - kAxis && one.right() <= frame.box.right + kRim &&
           std::ranges::none_of(words_, [&](const Words& other) {
             return &other != &one && other.row >= one.row && one.spans(other.x);
           });
  });
}

// Over the guide where all have room in one row; else beside it, to the right if they end within
// the frame.
void GuideWords::turn_inwards(const ChartFrame& frame) {
  for (Words& one : words_) {
    one.anchor = one.left() < frame.box.left            ? Anchor::start
                 : one.right() > frame.box.right + kRim ? Anchor::end
                                                        : Anchor::middle;
  }
  std::vector<const Words*> order;
  for (const Words& one : words_) {
    order.push_back(&one);
  }
  std::ranges::sort(order, {}, &Words::x);
  const auto meet = [](const Words* one, const Words* next) {
    constexpr double kAirBetween = 6.0;
    return one->right() + kAirBetween > next->left();
  };
  if (std::ranges::adjacent_find(order, meet) == order.end()) {
    return;
  }
  for (Words& one : words_) {
    one.anchor = Anchor::start;
    if (one.right() > frame.box.right + kRim) {
      one.anchor = Anchor::end;
    }
  }
}

// Above those whose guides would run through it, and beside no other.
void GuideWords::find_row(std::size_t i, std::size_t depth) {
  Words& one = words_[i];
  if (one.row >= 0 || depth > words_.size()) {
    return;
  }
  int row = 0;
  for (std::size_t j = 0; j < words_.size(); ++j) {
    if (j != i && one.spans(words_[j].x)) {
      find_row(j, depth + 1);
      row = std::max(row, words_[j].row + 1);
    }
  }
  const auto is_taken = [&] {
    return std::ranges::any_of(words_, [&](const Words& other) {
      return &other != &one && other.row == row && one.left() < other.right() &&
             other.left() < one.right();
    });
  };
  while (is_taken()) {
    ++row;
  }
  one.row = row;
}

int GuideWords::row_count() const {
  return words_rows() + (is_numbered_ ? static_cast<int>(words_.size()) : 0);
}

int GuideWords::words_rows() const {
  int count = 0;
  for (const Words& one : words_) {
    count = std::max(count, one.row + 1);
  }
  return count;
}

void GuideWords::draw(const ChartFrame& frame, Svg& svg) const {
  constexpr double kTop = 2.0;  // of a guide without words above the frame
  for (std::size_t i = 0; i < guides_.size(); ++i) {
    const double x = frame.place(guides_[i].x, frame.y.low).x;
    const bool has_words = i < words_.size();
    const double above = has_words ? 6.0 + kWordsHeight * words_[i].row : kTop;
    const bool has_title = !has_words && guides_.size() <= kMostWords;
    if (has_title) {
      svg.open_group(guides_[i].label);
    }
    svg.line({.x = x, .y = frame.box.top - above + (has_words ? kTop : 0.0)},
             {.x = x, .y = frame.box.bottom},
             {.stroke = Ink::ink, .width = 1.0, .dash = "4 3"});
    if (has_title) {
      svg.close_group();
    }
  }
  for (std::size_t i = 0; i < words_.size(); ++i) {
    const Words& one = words_[i];
    svg.text({.x = place_of(one.x, one.anchor), .y = frame.box.top - 6.0 - kWordsHeight * one.row},
             one.text,
             style_of(one.anchor));
  }
  if (is_numbered_) {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const int row = row_count() - 1 - static_cast<int>(i);
      svg.text({.x = frame.box.left, .y = frame.box.top - 6.0 - kWordsHeight * row},
               fmt::format("{} {}", i + 1, guides_[i].label),
               kGuideStyle);
    }
  }
}

}  // namespace kinestat
