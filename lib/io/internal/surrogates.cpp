#include "io/internal/surrogates.hpp"

#include <charconv>
#include <cstdint>
#include <string_view>

namespace kinestat {

namespace {

constexpr std::size_t kEscapeSize = kSurrogatesSize / 2;
constexpr std::uint32_t kFirstHigh = 0xD800;
constexpr std::uint32_t kFirstLow = 0xDC00;
constexpr std::uint32_t kCount = 0x400;  // of either

// The number of "\ud83d"; 0 of anything else.
std::uint32_t code_of_escape(const YamlText& text, std::size_t at) {
  constexpr int kHexadecimal = 16;
  const std::string_view digits = text.part(at + 2, at + kEscapeSize);
  std::uint32_t code = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, kHexadecimal);
  const bool is_whole = error == std::errc() && digits.size() == kEscapeSize - 2 &&
                        end == digits.data() + digits.size();
  return text[at] == '\\' && text[at + 1] == 'u' && is_whole ? code : 0;
}

bool is_within(std::uint32_t code, std::uint32_t first) {
  return code >= first && code < first + kCount;
}

}  // namespace

void find_surrogates(const YamlText& text,
                     std::size_t begin,
                     std::size_t end,
                     std::vector<std::size_t>& offsets) {
  for (std::size_t at = begin; at < end; ++at) {
    if (text[at] != '\\') {
      continue;
    }
    if (is_within(code_of_escape(text, at), kFirstHigh) &&
        is_within(code_of_escape(text, at + kEscapeSize), kFirstLow)) {
      offsets.push_back(at);
      at += kSurrogatesSize - 1;
    } else {
      ++at;  // what is escaped
    }
  }
}

char32_t code_of_surrogates(const YamlText& text, std::size_t at) {
  constexpr char32_t kFirst = 0x10000;
  return kFirst + kCount * (code_of_escape(text, at) - kFirstHigh) +
         (code_of_escape(text, at + kEscapeSize) - kFirstLow);
}

}  // namespace kinestat
