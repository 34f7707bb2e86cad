#include "studies/compare/compare_json_text.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

constexpr int kMostLevels = 64;

// An object that keeps its keys in order is searched from its beginning for every new key: about
// 20 000 keys in one object, or as much in many, take a second.
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
           "compare one report at a time; several files on one stream are a report a line",
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

// Sees every key while the text is read.
class KeyCheck {
 public:
  explicit KeyCheck(Diagnostics& found) : found_(found) {}

  // Answers whether the reader may keep the value.
  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (found_.has_errors()) {
      return false;
    }
    if (depth >= kMostLevels && (event == Event::object_start || event == Event::array_start)) {
      refuse_thing(fmt::format("nesting deeper than {} levels", kMostLevels));
    }
    if (event == Event::object_start) {
      keys_.emplace_back();
    } else if (event == Event::object_end) {
      keys_.pop_back();
    } else if (event == Event::key) {
      see_key(parsed.get<std::string>());
    }
    return !found_.has_errors();
  }

 private:
  void see_key(const std::string& key) {
    if (!keys_.back().insert(key).second) {
      refuse_thing(
          fmt::format("the key '{}' is given twice in one object", printable(key.substr(0, 80))));
    }
    search_steps_ += keys_.back().size();
    if (search_steps_ > kMostSearchSteps) {
      refuse_thing("an object has too many keys");
    }
  }

  void refuse_thing(std::string message) {
    refuse({}, std::move(message), "a report of this program has no such thing", found_);
  }

  Diagnostics& found_;
  std::vector<std::set<std::string>> keys_;
  std::size_t search_steps_ = 0;
};

}  // namespace

std::optional<Json> read_json(const SourceFile& source, Diagnostics& found) {
  Diagnostics wrong;
  KeyCheck check(wrong);
  Json value;
  try {
    value = Json::parse(source.text, [&check](int depth, Json::parse_event_t event, Json& parsed) {
      return check(depth, event, parsed);
    });
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
  return value;
}

}  // namespace kinestat
