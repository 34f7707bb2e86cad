// What the tests of this folder look for in pictures.
#pragma once

#include <limits>
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

}  // namespace kinestat
