// What the tests of this folder look for in pictures.
#pragma once

#include <limits>
#include <regex>
#include <string>

#include "draw/picture.hpp"

namespace kinestat {

/// Where a line has a gap.
inline constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline bool has(const Picture& picture, const std::string& part) {
  return has(picture.elements, part);
}

inline std::size_t count_of(const Picture& picture, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = picture.elements.find(text); at != std::string::npos;
       at = picture.elements.find(text, at + 1)) {
    ++count;
  }
  return count;
}

/// The number of an attribute where the picture has it first; NaN where it has none.
inline double attribute(const Picture& picture, const std::string& name) {
  std::smatch match;
  const std::regex pattern(name + "=\"([^\"]*)\"");
  return std::regex_search(picture.elements, match, pattern)
             ? std::stod(match[1])
             : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace kinestat
