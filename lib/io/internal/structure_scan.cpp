#include "io/internal/structure_scan.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/internal/block_stack.hpp"
#include "io/internal/scalar_end.hpp"
#include "io/internal/structure_words.hpp"
#include "io/internal/surrogates.hpp"
#include "io/internal/yaml_text.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kNowhere = std::string::npos;

class Scan {
 public:
  Scan(SourceMap& map, const ReadLimits& limits, Diagnostics& found)
      : map_(map), limits_(limits), found_(found), text_(map.text()) {}

  bool run();

 private:
  enum class Step { go_on, finished, refused };

  Step skip_to_token();
  Step token();
  Step block_token();
  Step scalar_token();
  Step open_bracket();
  Step close_bracket();
  Step comma();
  Step refuse_values();
  Step quoted();
  Step plain();
  Step block_scalar();
  Step refuse_tab(std::size_t tab);

  bool in_brackets() const { return !brackets_.empty(); }

  Context context() const { return in_brackets() ? Context::in_brackets : Context::block; }

  int column() const { return static_cast<int>(at_ - line_start_); }

  bool is_value_mark() const;
  void close_blocks();
  void note_key_start();
  void value_mark();
  void go_to(std::size_t offset);

  SourceMap& map_;
  const ReadLimits& limits_;
  Diagnostics& found_;
  const YamlText& text_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  std::size_t key_start_ = kNowhere;  // where a key of this line may have begun
  bool is_after_json_ = false;        // behind a quote or bracket ':' needs no space
  int commas_ = 0;
  int collections_ = 0;
  std::vector<std::size_t> brackets_;  // offsets of the open ones
  BlockStack blocks_;
  std::vector<std::size_t> surrogates_;  // offsets of pairs of escapes
};

bool Scan::run() {
  Step step = Step::go_on;
  while (step == Step::go_on) {
    step = skip_to_token();
    if (step == Step::go_on) {
      step = token();
    }
  }
  if (step == Step::finished) {
    map_.join_surrogates(surrogates_);
  }
  return step == Step::finished;
}

void Scan::go_to(std::size_t offset) {
  const std::size_t last_break = text_.part(at_, offset).rfind('\n');
  if (last_break != kNowhere) {
    line_start_ = at_ + last_break + 1;
  }
  at_ = offset;
}

Scan::Step Scan::skip_to_token() {
  std::size_t tab = kNowhere;
  while (true) {
    const bool is_indentation = at_ == line_start_;
    const std::size_t blanks = at_;
    at_ = text_.skip_blanks(at_);
    const std::size_t first_tab = text_.part(blanks, at_).find('\t');
    tab = is_indentation && first_tab != kNowhere ? blanks + first_tab : kNowhere;
    if (text_[at_] == '#') {
      at_ = text_.skip_line(at_);
    }
    if (text_.line_break(at_) == 0) {
      break;
    }
    go_to(at_ + text_.line_break(at_));
  }
  // Inside brackets indentation means nothing, and a tab is a space like others.
  if (!in_brackets()) {
    return text_.is_end(at_) ? Step::finished : (tab != kNowhere ? refuse_tab(tab) : Step::go_on);
  }
  if (text_.is_end(at_)) {
    report_open_bracket(map_, brackets_.back(), at_, found_);
    return Step::refused;
  }
  return Step::go_on;
}

void Scan::close_blocks() {
  const bool is_item = text_[at_] == '-' && text_.is_space_or_end(at_ + 1);
  blocks_.close_until(column(), is_item ? Block::list : Block::mapping);
}

void Scan::note_key_start() {
  if (!in_brackets() && (key_start_ == kNowhere || key_start_ < line_start_)) {
    key_start_ = at_;
  }
}

Scan::Step Scan::token() {
  if (column() == 0 && text_[at_] == '%') {
    at_ = text_.skip_line(at_);
    return Step::go_on;
  }
  if (text_.is_document_mark(at_)) {
    blocks_.clear();
    key_start_ = kNowhere;
    is_after_json_ = false;
    at_ += 3;
    return Step::go_on;
  }
  switch (text_[at_]) {
    case '[':
    case '{':
      return open_bracket();
    case ']':
    case '}':
      return close_bracket();
    case ',':
      return comma();
    default:
      return block_token();
  }
}

Scan::Step Scan::open_bracket() {
  if (!in_brackets()) {
    close_blocks();
  }
  if (static_cast<int>(brackets_.size()) >= limits_.depth) {
    report_depth(limits_, map_.at(at_), found_);
    return Step::refused;
  }
  if (++collections_ > limits_.nodes) {
    return refuse_values();
  }
  note_key_start();
  brackets_.push_back(at_);
  is_after_json_ = false;
  ++at_;
  return Step::go_on;
}

Scan::Step Scan::close_bracket() {
  if (!in_brackets()) {
    report_loose_bracket(map_, at_, found_);
    return Step::refused;
  }
  if ((text_[brackets_.back()] == '[') != (text_[at_] == ']')) {
    report_wrong_bracket(map_, brackets_, at_, found_);
    return Step::refused;
  }
  brackets_.pop_back();
  is_after_json_ = true;
  ++at_;
  return Step::go_on;
}

// Every comma inside brackets stands for a value, and so does every bracket: too many values are
// known without building them.
Scan::Step Scan::comma() {
  is_after_json_ = false;
  commas_ += in_brackets() ? 1 : 0;
  if (commas_ > limits_.nodes) {
    return refuse_values();
  }
  ++at_;
  return Step::go_on;
}

Scan::Step Scan::refuse_values() {
  report_nodes(limits_, map_.at(at_), Excess::by_value, found_);
  return Step::refused;
}

Scan::Step Scan::block_token() {
  if (!in_brackets()) {
    close_blocks();
  }
  const char c = text_[at_];
  const bool is_item = c == '-' && text_.is_space_or_end(at_ + 1);
  const bool is_key = c == '?' && text_.is_space(at_ + 1);
  if (is_item || is_key) {
    if (!in_brackets()) {
      blocks_.open(column(), is_item ? Block::list : Block::mapping);
      key_start_ = kNowhere;
    } else if (is_item) {
      return Step::finished;  // illegal here: the parser says so
    }
    is_after_json_ = is_after_json_ && is_key;
    ++at_;
    return Step::go_on;
  }
  if (is_value_mark()) {
    value_mark();
    return Step::go_on;
  }
  return scalar_token();
}

bool Scan::is_value_mark() const {
  if (text_[at_] != ':') {
    return false;
  }
  if (!in_brackets()) {
    return text_.is_space_or_end(at_ + 1);
  }
  return is_after_json_ || text_.is_space(at_ + 1) || is_one_of(text_[at_ + 1], ",]}");
}

void Scan::value_mark() {
  if (!in_brackets()) {
    const bool has_key = key_start_ != kNowhere && key_start_ >= line_start_;
    blocks_.open(static_cast<int>((has_key ? key_start_ : at_) - line_start_), Block::mapping);
    key_start_ = kNowhere;
  }
  is_after_json_ = false;
  ++at_;
}

Scan::Step Scan::scalar_token() {
  const char c = text_[at_];
  if ((c == '|' || c == '>') && !in_brackets()) {
    return block_scalar();
  }
  if (c == '\'' || c == '"') {
    return quoted();
  }
  if (!is_one_of(c, "&*!")) {
    return is_plain_start(text_, at_, context()) ? plain() : Step::finished;
  }
  note_key_start();
  is_after_json_ = false;
  at_ = find_name_end(text_, at_);
  return Step::go_on;
}

Scan::Step Scan::quoted() {
  const std::size_t end = find_quote_end(text_, at_);
  if (end == kNowhere) {
    report_open_quote(map_, at_, found_);
    return Step::refused;
  }
  if (text_[at_] == '"') {
    find_surrogates(text_, at_, end, surrogates_);
  }
  note_key_start();
  is_after_json_ = true;
  go_to(end);
  return Step::go_on;
}

Scan::Step Scan::plain() {
  note_key_start();
  is_after_json_ = false;
  const int indent = in_brackets() ? 0 : blocks_.column() + 1;
  const ScalarEnd end = find_plain_end(text_, at_, indent, context());
  go_to(end.offset);
  return end.is_at_tab ? refuse_tab(at_) : Step::go_on;
}

Scan::Step Scan::block_scalar() {
  key_start_ = kNowhere;
  is_after_json_ = false;
  const ScalarEnd end = find_block_scalar_end(text_, at_, std::max(blocks_.column(), 0));
  go_to(end.offset);
  return end.is_at_tab ? refuse_tab(at_) : Step::go_on;
}

Scan::Step Scan::refuse_tab(std::size_t tab) {
  report_tab(map_, tab, found_);
  return Step::refused;
}

}  // namespace

bool scan_structure(SourceMap& map, const ReadLimits& limits, Diagnostics& found) {
  return Scan(map, limits, found).run();
}

}  // namespace kinestat
