// Large JSON texts, read by RapidJSON.
#pragma once

#include <charconv>
#include <cstdint>
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>
#include <string>
#include <string_view>
#include <system_error>

#include "core/utf8.hpp"

namespace kinestat {

/// Tells an object with the functions that nlohmann's reader calls what RapidJSON's calls say.
template <class Events>
class FastJsonHandler {
 public:
  using Size = rapidjson::SizeType;

  explicit FastJsonHandler(Events& events) : events_(events) {}

  bool Null() { return events_.null(); }

  bool Bool(bool value) { return events_.boolean(value); }

  bool Int(int value) { return events_.number_integer(value); }

  bool Int64(std::int64_t value) { return events_.number_integer(value); }

  bool Uint(unsigned value) { return events_.number_unsigned(value); }

  bool Uint64(std::uint64_t value) { return events_.number_unsigned(value); }

  bool Double(double value) { return events_.number_float(value, {}); }

  // All numbers come so: it reads whole ones of more than 19 digits wrongly itself.
  bool RawNumber(const char* text, Size length, bool /*copy*/) {
    const std::string_view number(text, length);
    if (number.find_first_of(".eE") != std::string_view::npos) {
      return read<double>(number, [this](double value) { return Double(value); });
    }
    return number.front() == '-'
               ? read<std::int64_t>(number, [this](auto value) { return Int64(value); })
               : read<std::uint64_t>(number, [this](auto value) { return Uint64(value); });
  }

  bool String(const char* text, Size length, bool /*copy*/) {
    return take(text, length) && events_.string(text_);
  }

  bool Key(const char* text, Size length, bool /*copy*/) {
    return take(text, length) && events_.key(text_);
  }

  bool StartObject() { return events_.start_object(0); }

  bool EndObject(Size /*members*/) { return events_.end_object(); }

  bool StartArray() { return events_.start_array(0); }

  bool EndArray(Size /*items*/) { return events_.end_array(); }

 private:
  // False of what is beyond its type.
  template <class Number, class Take>
  static bool read(std::string_view text, const Take& take_number) {
    Number number{};
    const char* const behind = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), behind, number);
    return error == std::errc() && end == behind && take_number(number);
  }

  // RapidJSON takes the second half of a surrogate pair alone, which would begin with this byte.
  bool take(const char* text, Size length) {
    text_.assign(text, length);
    return text_.find('\xED') == std::string::npos || !find_bad_character(text_);
  }

  Events& events_;
  std::string text_;
};

/// In a fraction of the time of nlohmann's reader. Only says whether the text is right; why it is
/// not, the other tells.
template <class Events>
bool read_fast_json(std::string_view text, Events& events) {
  constexpr unsigned kHow = rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseIterativeFlag |
                            rapidjson::kParseValidateEncodingFlag;
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
  }
  rapidjson::MemoryStream stream(text.data(), text.size());
  FastJsonHandler<Events> handler(events);
  rapidjson::Reader reader;
  // The end looks like a zero byte to it, and so does a zero byte like the end.
  return !reader.Parse<kHow>(stream, handler).IsError() && stream.Tell() == text.size();
}

}  // namespace kinestat
