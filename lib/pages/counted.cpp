#include "pages/counted.hpp"

#include <fmt/format.h>

namespace kinestat {

std::string counted(int number, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string counted(int number, std::string_view noun) {
  return counted(number, noun, fmt::format("{}s", noun));
}

}  // namespace kinestat
