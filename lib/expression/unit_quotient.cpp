#include "expression/unit_quotient.hpp"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

namespace kinestat {

namespace {

// A unit and its power, below zero where it divides.
struct Factor {
  std::string_view unit;
  int power = 1;
};

// Of units as the program writes them: words with whole powers, products, quotients, parentheses.
class FactorReader {
 public:
  FactorReader(std::string_view text, int sign, std::vector<Factor>& factors)
      : text_(text), factors_(factors) {
    read(sign);
  }

 private:
  void read(int sign) {
    int next = sign;
    while (at_ < text_.size() && text_[at_] != ')') {
      const char here = text_[at_];
      if (here == '*' || here == '/') {
        next = here == '/' ? -sign : sign;
        ++at_;
      } else if (here == '(') {
        ++at_;
        read(next);
        ++at_;
      } else {
        add(next);
      }
    }
  }

  void add(int sign) {
    const std::size_t end = std::min(text_.find_first_of("*/()^", at_), text_.size());
    Factor factor = {.unit = text_.substr(at_, end - at_), .power = sign};
    at_ = end;
    if (at_ < text_.size() && text_[at_] == '^') {
      int power = 1;
      const char* const begin = text_.data() + at_ + 1;
      at_ = static_cast<std::size_t>(
          std::from_chars(begin, text_.data() + text_.size(), power).ptr - text_.data());
      factor.power *= power;
    }
    if (factor.unit == "1") {
      return;
    }
    const auto same = std::ranges::find(factors_, factor.unit, &Factor::unit);
    if (same == factors_.end()) {
      factors_.push_back(factor);
    } else {
      same->power += factor.power;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Factor>& factors_;
};

// Those with powers of the sign: "kg*mm^2".
std::string product(const std::vector<Factor>& factors, int sign) {
  std::string text;
  for (const Factor& one : factors) {
    const int power = sign * one.power;
    if (power > 0) {
      text += text.empty() ? "" : "*";
      text += one.unit;
      text += power > 1 ? "^" + std::to_string(power) : "";
    }
  }
  return text;
}

}  // namespace

std::string unit_quotient(std::string_view above, std::string_view below) {
  std::vector<Factor> factors;
  FactorReader(above, 1, factors);
  FactorReader(below, -1, factors);
  std::string text = product(factors, 1);
  const std::string divisor = product(factors, -1);
  if (divisor.empty()) {
    return text;
  }
  const bool is_compound = divisor.find('*') != std::string::npos;
  text += text.empty() ? "1/" : "/";
  return text + (is_compound ? "(" + divisor + ")" : divisor);
}

}  // namespace kinestat
