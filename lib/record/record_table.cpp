#include "record/record_table.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

#include <fmt/format.h>

#include "core/page_text.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "record/measure_word.hpp"

namespace kinestat {

namespace {

std::string kind_text(const Shape& shape);

// "3 of length", or "3 of moment, 3 of force".
std::string components_of(const Shape& tuple) {
  std::string text;
  for (auto at = tuple.items.begin(); at != tuple.items.end();) {
    const std::string kind = kind_text(*at);
    const auto end = std::find_if(
        at, tuple.items.end(), [&](const Shape& one) { return kind_text(one) != kind; });
    text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", end - at, kind);
    at = end;
  }
  return text;
}

std::string with_items(std::string_view collection, std::string_view link, const Shape& item) {
  const std::string kind = kind_text(item);
  return fmt::format("{}{}{}", collection, kind.empty() ? "" : link, kind);
}

// Of an object nothing: its keys say it.
std::string kind_alone(const Shape& shape) {
  switch (shape.form) {
    case Shape::Form::number:
    case Shape::Form::whole:
      return word_of(shape.measure) + (shape.may_be_by_name ? ", or several by name" : "");
    case Shape::Form::text:
      return "text";
    case Shape::Form::word:
      return plain_list(shape.words, shape.words.size());
    case Shape::Form::flag:
      return "true or false";
    case Shape::Form::object:
      return "";
    case Shape::Form::map:
      return with_items(
          shape.words.empty() ? "by name" : "by " + plain_list(shape.words, shape.words.size()),
          ": ",
          shape.items.front());
    case Shape::Form::list:
      return with_items("list", " of ", shape.items.front());
    case Shape::Form::tuple:
      return components_of(shape);
    case Shape::Form::cell:
      return "number or text";
  }
  return "";
}

std::string kind_text(const Shape& shape) {
  const std::string kind = kind_alone(shape);
  return shape.is_nullable && !kind.empty() ? kind + ", or null" : kind;
}

class KeyList {
 public:
  explicit KeyList(const std::function<std::string(const RecordShape&)>& page_of)
      : page_of_(page_of) {}

  void add(const RecordShape& record, std::size_t indent) {
    std::size_t longest = 0;
    for (const Property& one : record.properties) {
      longest = std::max(longest, one.is_in_reports ? columns_of(one.key) : 0);
    }
    for (const Property& one : record.properties) {
      if (one.is_in_reports) {
        add_key(one, indent, indent + longest + 2);
      }
    }
  }

  const std::string& text() const { return text_; }

 private:
  void add_key(const Property& one, std::size_t indent, std::size_t begin) {
    const RecordShape* below = record_behind(one.shape);
    const std::string page = below != nullptr ? page_of_(*below) : "";
    const auto told = told_.find(below);
    const std::string elsewhere = !page.empty()         ? page
                                  : told != told_.end() ? fmt::format("as '{}'", told->second)
                                                        : "";
    const std::string kind = kind_text(one.shape);
    const std::string facts =
        fmt::format("{}{}{}", kind, kind.empty() || elsewhere.empty() ? "" : "; ", elsewhere);
    const std::string words =
        facts.empty() ? one.meaning : fmt::format("({}) {}", facts, one.meaning);
    const std::string key = fmt::format("{:{}}{}", "", indent, one.key);
    text_ += page_lines(key, words, begin);
    if (below != nullptr && elsewhere.empty()) {
      told_[below] = one.key;
      add(*below, indent + 2);
    }
  }

  const std::function<std::string(const RecordShape&)>& page_of_;
  std::string text_;
  std::map<const RecordShape*, std::string> told_;  // behind which key
};

}  // namespace

const RecordShape* record_behind(const Shape& shape) {
  const Shape* at = &shape;
  while (at->record == nullptr && !at->items.empty()) {
    at = &at->items.front();
  }
  return at->record;
}

std::string record_table(const RecordShape& record,
                         const std::function<std::string(const RecordShape&)>& page_of) {
  KeyList table(page_of);
  table.add(record, 2);
  return table.text();
}

}  // namespace kinestat
