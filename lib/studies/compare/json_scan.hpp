// Large JSON texts, which are read without a second look at any byte.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/utf8.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Tells what stands in a text to an object with the functions that nlohmann's reader calls, in a
/// fifth of its time. It only says whether the text is right; why not, the other tells.
template <typename Events>
class JsonScan {
 public:
  JsonScan(std::string_view text, Events& events)
      : at_(text.data()), end_(text.data() + text.size()), events_(events) {}

  /// False of what is no JSON, and of numbers that are better left to the other reader.
  bool run() {
    if (std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(kByteOrderMark)) {
      at_ += kByteOrderMark.size();
    }
    skip_blanks();
    bool is_right = value();
    while (is_right && !open_.empty()) {
      is_right = next_item();
    }
    skip_blanks();
    return is_right && at_ == end_;
  }

 private:
  static constexpr std::size_t kMostLevels = 1000;

  char next() const { return at_ == end_ ? '\0' : *at_; }

  void skip_blanks() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) {
      ++at_;
    }
  }

  bool take(char c) {
    const bool is_it = next() == c;
    at_ += is_it ? 1 : 0;
    return is_it;
  }

  // One that is open afterwards, or whole.
  bool value() {
    switch (next()) {
      case '{':
        return open('}') && events_.start_object(0);
      case '[':
        return open(']') && events_.start_array(0);
      case '"':
        return text() && events_.string(text_);
      case 't':
        return word("true") && events_.boolean(true);
      case 'f':
        return word("false") && events_.boolean(false);
      case 'n':
        return word("null") && events_.null();
      default:
        return number();
    }
  }

  bool open(char closing) {
    ++at_;
    is_first_ = true;
    open_.push_back(closing);
    return open_.size() <= kMostLevels;
  }

  // Of what is open, or its end.
  bool next_item() {
    const char closing = open_.back();
    skip_blanks();
    if (take(closing)) {
      open_.pop_back();
      is_first_ = false;
      return closing == '}' ? events_.end_object() : events_.end_array();
    }
    if (!is_first_ && !take(',')) {
      return false;
    }
    is_first_ = false;
    skip_blanks();
    if (closing == '}') {
      if (next() != '"' || !text() || !events_.key(text_)) {
        return false;
      }
      skip_blanks();
      if (!take(':')) {
        return false;
      }
      skip_blanks();
    }
    return value();
  }

  bool word(std::string_view expected) {
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    at_ += rest.starts_with(expected) ? expected.size() : 0;
    return rest.starts_with(expected);
  }

  // From one quote to the next.
  bool text() {
    const char* const begin = at_++;
    bool is_plain = true;
    bool is_ascii = true;
    while (at_ != end_ && *at_ != '"') {
      const auto byte = static_cast<unsigned char>(*at_);
      is_ascii = is_ascii && byte < 0x80;
      is_plain = is_plain && byte >= ' ' && byte != '\\';
      at_ += *at_ == '\\' && at_ + 1 != end_ ? 2 : 1;
    }
    if (!take('"')) {
      return false;
    }
    text_.assign(begin + 1, at_ - 1);
    if (is_plain && (is_ascii || !find_bad_character(text_))) {
      return true;
    }
    const Json read = Json::parse(begin, at_, nullptr, false);
    text_ = read.is_string() ? read.get<std::string>() : std::string();
    return read.is_string();
  }

  bool digits() {
    const char* const begin = at_;
    while (next() >= '0' && next() <= '9') {
      ++at_;
    }
    return at_ != begin;
  }

  bool number() {
    const char* const begin = at_;
    const bool is_negative = take('-');
    bool is_whole = true;
    if (!take('0') && !digits()) {
      return false;
    }
    if (take('.')) {
      is_whole = false;
      if (!digits()) {
        return false;
      }
    }
    if (take('e') || take('E')) {
      is_whole = false;
      (void)(take('+') || take('-'));
      if (!digits()) {
        return false;
      }
    }
    if (is_whole) {
      return is_negative
                 ? read<std::int64_t>(begin, [&](auto v) { return events_.number_integer(v); })
                 : read<std::uint64_t>(begin, [&](auto v) { return events_.number_unsigned(v); });
    }
    return read<double>(begin, [&](double v) { return events_.number_float(v, {}); });
  }

  template <typename Number, typename Take>
  bool read(const char* begin, Take take_number) {
    Number number{};
    const auto [end, error] = std::from_chars(begin, at_, number);
    return error == std::errc() && end == at_ && take_number(number);
  }

  const char* at_;
  const char* end_;
  Events& events_;
  std::string text_;        // that was read last
  std::vector<char> open_;  // how each ends
  bool is_first_ = false;   // nothing was read of what was opened last
};

}  // namespace kinestat
