#include "studies/compare/compare_json_text.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

constexpr int kMostLevels = 64;

// An object that keeps its keys in order is searched from its beginning for a key: no object may
// have more than about 20 000, nor all together as much to search.
constexpr std::size_t kMostSearchSteps = 200'000'000;

void refuse(SourceRange where, std::string message, std::string hint, Diagnostics& found) {
  found.error("E0903", where, std::move(message), std::move(hint));
}

// The place of a byte; columns count characters.
SourceRange place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') + 1;  // 0 if there is none
  return {.line = 1 + static_cast<int>(std::ranges::count(before, '\n')),
          .column = 1 + static_cast<int>(count_characters(before.substr(line_start))),
          .length = 1};
}

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
}

// The word around a byte: what was meant for a number or a literal.
std::string_view word_at(std::string_view text, std::size_t& offset) {
  offset = std::min(offset, text.size());
  while (offset > 0 && is_of_word(text[offset - 1])) {
    --offset;
  }
  const std::string_view rest = text.substr(offset);
  const auto end = std::ranges::find_if_not(rest, is_of_word);
  return rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
}

bool is_not_a_number(std::string_view word) {
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return lower.find("nan") != std::string::npos || lower.find("inf") != std::string::npos;
}

// `byte` counts from 1, and is that of the last byte that was read.
void refuse_syntax(std::string_view text,
                   std::size_t byte,
                   std::string_view what,
                   Diagnostics& found) {
  std::size_t offset = byte == 0 ? 0 : byte - 1;
  if (offset >= text.size()) {
    refuse(place_of(text, text.size()),
           "the JSON ends too early",
           "the file was perhaps cut off while it was copied",
           found);
    return;
  }
  if (what.find("expected end of input") != std::string_view::npos) {
    refuse(place_of(text, offset),
           "there is more after the report",
           "several reports stand a line each, as commands on several files write them",
           found);
    return;
  }
  const std::string_view word = word_at(text, offset);
  SourceRange where = place_of(text, offset);
  where.length = std::max(1, static_cast<int>(word.size()));
  if (is_not_a_number(word)) {
    refuse(where,
           fmt::format("'{}' is not JSON", printable(word.substr(0, 40))),
           "a report has null where there is no value",
           found);
    return;
  }
  refuse(where, "this is not JSON from here on", "", found);
}

// Puts the value together as its parts are read, and stops to do so at the first thing that no
// report has. Items wait until the end of their list or object is read: it is made in its size
// then, where one that grew would copy all below it, for nlohmann's objects have constant keys.
class JsonBuilder {
 public:
  explicit JsonBuilder(Diagnostics& found) : found_(found) {}

  Json take_value() { return std::move(whole_); }

  // What nlohmann's reader calls. Each answers that it shall read on: what is no JSON matters more.
  bool null() { return put(Json()); }

  bool boolean(bool value) { return put(value); }

  bool number_integer(Json::number_integer_t value) { return put(value); }

  bool number_unsigned(Json::number_unsigned_t value) { return put(value); }

  bool number_float(Json::number_float_t value, const std::string& /*text*/) { return put(value); }

  bool string(std::string& value) { return put(value); }

  bool binary(Json::binary_t& value) { return put(Json::binary(value)); }

  bool start_object(std::size_t /*size*/) { return open(true); }

  bool start_array(std::size_t /*size*/) { return open(false); }

  bool end_array() { return close(); }

  bool end_object() { return close(); }

  bool key(const std::string& key) {
    if (!found_.has_errors()) {
      see_key(key);
      keys_.push_back(key);
      items_.emplace_back();
    }
    return true;
  }

  template <typename Error>
  [[noreturn]] bool parse_error(std::size_t /*byte*/,
                                const std::string& /*token*/,
                                const Error& error) {
    throw error;
  }

 private:
  // A list or an object that was not read to its end.
  struct Open {
    std::size_t begin = 0;      // of its items among those that wait
    std::size_t begin_key = 0;  // likewise of its keys
    bool is_object = false;
    std::unordered_set<std::string> keys;  // only if they are many
  };

  bool put(Json value) {
    if (found_.has_errors()) {
      return true;
    }
    if (open_.empty()) {
      whole_ = std::move(value);
    } else if (open_.back().is_object) {
      items_.back() = std::move(value);
    } else {
      items_.push_back(std::move(value));
    }
    return true;
  }

  bool open(bool is_object) {
    if (open_.size() >= kMostLevels) {
      refuse_thing(fmt::format("nesting deeper than {} levels", kMostLevels));
    }
    if (!found_.has_errors()) {
      open_.push_back(
          {.begin = items_.size(), .begin_key = keys_.size(), .is_object = is_object, .keys = {}});
    }
    return true;
  }

  bool close() {
    if (found_.has_errors()) {
      return true;
    }
    const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(open_.back().begin);
    Json value = open_.back().is_object ? object_of(begin) : list_of(begin);
    items_.erase(begin, items_.end());
    keys_.resize(open_.back().begin_key);
    open_.pop_back();
    return put(std::move(value));
  }

  Json object_of(std::vector<Json>::iterator item) {
    Json::object_t object;
    object.reserve(static_cast<std::size_t>(items_.end() - item));
    for (std::size_t k = open_.back().begin_key; k < keys_.size(); ++k, ++item) {
      object.emplace_back(std::move(keys_[k]), std::move(*item));
    }
    return object;
  }

  Json list_of(std::vector<Json>::iterator item) {
    return Json::array_t(std::make_move_iterator(item), std::make_move_iterator(items_.end()));
  }

  void see_key(const std::string& key) {
    if (!is_new(key)) {
      refuse_thing(
          fmt::format("the key '{}' is given twice in one object", printable(key.substr(0, 80))));
    }
    search_steps_ += keys_.size() - open_.back().begin_key + 1;
    if (search_steps_ > kMostSearchSteps) {
      refuse_thing("an object has too many keys");
    }
  }

  // A few keys are faster searched than kept in a set.
  bool is_new(const std::string& key) {
    constexpr std::ptrdiff_t kFewKeys = 16;
    const auto begin = keys_.begin() + static_cast<std::ptrdiff_t>(open_.back().begin_key);
    if (keys_.end() - begin < kFewKeys) {
      return std::find(begin, keys_.end(), key) == keys_.end();
    }
    std::unordered_set<std::string>& keys = open_.back().keys;
    if (keys.empty()) {
      keys.insert(begin, keys_.end());
    }
    return keys.insert(key).second;
  }

  // Of several things the first is told.
  void refuse_thing(std::string message) {
    if (!found_.has_errors()) {
      refuse({}, std::move(message), "a report of this program has no such thing", found_);
    }
  }

  Diagnostics& found_;
  std::vector<Json> items_;
  std::vector<std::string> keys_;  // of those items that are of objects
  std::vector<Open> open_;
  Json whole_;
  std::size_t search_steps_ = 0;
};

}  // namespace

std::optional<Json> read_json(const SourceFile& source, Diagnostics& found) {
  Diagnostics wrong;
  JsonBuilder builder(wrong);
  try {
    Json::sax_parse(source.text, &builder);
  } catch (const Json::parse_error& error) {
    refuse_syntax(source.text, error.byte, error.what(), found);
    return {};
  } catch (const Json::exception&) {
    refuse({}, "a number is beyond what a double holds", "", found);
    return {};
  }
  if (wrong.has_errors()) {
    const Diagnostic& first = wrong.items().front();
    refuse({}, first.message, first.hint, found);
    return {};
  }
  return builder.take_value();
}

}  // namespace kinestat
