// Random spellings of one tree.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "property/expression_sample.hpp"

namespace kinestat::sample {

namespace {

// How closely a text holds together: what stands in it without parentheses.
enum class Level { sum, product, with_sign, measure, power, atom };

struct Text {
  std::string text;
  Level level = Level::atom;
};

class Speller {
 public:
  Speller(std::mt19937& random, Calls calls) : random_(random), calls_(calls) {}

  Text spell(const Tree& tree);

 private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  std::string blank() { return pick(3) == 0 ? " " : ""; }

  std::string within(const Tree& tree, Level least);
  std::string literal(const Tree& tree);
  Text joined(const Tree& tree, const char* symbol, Level level, Level right);
  Text multiplied(const Tree& tree);
  Text raised(const Tree& tree);
  Text called(const Tree& tree);

  std::mt19937& random_;
  Calls calls_;
};

// With parentheses where they are needed, and sometimes where they are not.
std::string Speller::within(const Tree& tree, Level least) {
  const Text inner = spell(tree);
  if (inner.level >= least && pick(8) != 0) {
    return inner.text;
  }
  return fmt::format("({}{}{})", blank(), inner.text, blank());
}

// 1250 with 3 decimals: 1.250, 1.25, 1250e-3, 0.125E1, …
std::string Speller::literal(const Tree& tree) {
  if (tree.decimals == 0 && pick(2) == 0) {
    return std::to_string(tree.digits);
  }
  const int shift = pick(4) == 0 ? pick(5) - 2 : 0;  // the exponent of ten that is written
  const int decimals = std::max(tree.decimals + shift, 0);
  std::string digits = std::to_string(tree.digits);
  digits.append(static_cast<std::size_t>(decimals - tree.decimals - shift), '0');
  if (digits.find_first_not_of('0') == std::string::npos) {
    digits = "0";
  }
  if (static_cast<int>(digits.size()) <= decimals) {
    digits.insert(0, static_cast<std::size_t>(decimals + 1) - digits.size(), '0');
  }
  std::string text = digits.substr(0, digits.size() - static_cast<std::size_t>(decimals));
  const std::string fraction = digits.substr(text.size());
  if (!fraction.empty() || pick(4) == 0) {
    text += "." + fraction + (pick(4) == 0 ? "0" : "");
  }
  if (text.starts_with("0.") && text.size() > 2 && pick(3) == 0) {
    text.erase(0, 1);
  }
  if (shift != 0 || pick(8) == 0) {
    text += fmt::format(
        "{}{}{}", pick(2) == 0 ? "e" : "E", shift > 0 && pick(2) == 0 ? "+" : "", shift);
  }
  return text;
}

Text Speller::joined(const Tree& tree, const char* symbol, Level level, Level right) {
  std::string text = within(tree.parts[0], level);
  text += blank() + symbol + blank();
  return {text + within(tree.parts[1], right), level};
}

Text Speller::multiplied(const Tree& tree) {
  const Tree& left = tree.parts[0];
  const Tree& right = tree.parts[1];
  const bool may_touch = right.kind == Kind::unit && left.kind == Kind::literal;
  if (may_touch && pick(6) != 0) {
    const std::string number = literal(left);
    const bool is_point = number.ends_with('.');  // "3.mm" reads as a wrong product
    return {pick(6) == 0
                ? fmt::format("({}){}{}", number, blank(), right.word)
                : fmt::format("{}{}{}", number, is_point || pick(4) != 0 ? " " : "", right.word),
            Level::measure};
  }
  if (right.kind == Kind::unit && pick(10) == 0) {
    return {fmt::format("({}){}{}", spell(left).text, blank(), right.word), Level::measure};
  }
  return joined(tree, "*", Level::product, Level::with_sign);
}

Text Speller::raised(const Tree& tree) {
  const Tree& exponent = tree.parts[1];
  std::string text = within(tree.parts[0], Level::atom) + blank() + "^" + blank();
  if (exponent.kind == Kind::negate && pick(2) == 0) {
    return {text + "-" + within(exponent.parts[0], Level::power), Level::power};
  }
  return {text + within(exponent, Level::power), Level::power};
}

// max(max(a, b), c) may be written max(a, b, c).
Text Speller::called(const Tree& tree) {
  static const std::vector<std::string> kOfMany = {"min", "max", "gcd", "hypot"};
  std::vector<const Tree*> values;
  const Tree* first = &tree;
  const bool may_be_flat =
      calls_ == Calls::also_flat && std::ranges::find(kOfMany, tree.word) != kOfMany.end();
  do {
    for (std::size_t i = first->parts.size() - 1; i > 0; --i) {
      values.insert(values.begin(), &first->parts[i]);
    }
    first = &first->parts[0];
  } while (may_be_flat && first->kind == Kind::call && first->word == tree.word && pick(4) != 0);
  values.insert(values.begin(), first);
  std::string text = tree.word + blank() + "(" + blank();
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i == 0 ? "" : "," + blank()) + spell(*values[i]).text;
  }
  return {text + blank() + ")", Level::atom};
}

Text Speller::spell(const Tree& tree) {
  switch (tree.kind) {
    case Kind::literal:
      return {literal(tree), Level::atom};
    case Kind::unit:
    case Kind::name:
    case Kind::pi:
      return {tree.word, Level::atom};
    case Kind::negate:
      return {"-" + blank() + within(tree.parts[0], Level::with_sign), Level::with_sign};
    case Kind::add:
      return joined(tree, "+", Level::sum, Level::product);
    case Kind::subtract:
      return joined(tree, "-", Level::sum, Level::product);
    case Kind::multiply:
      return multiplied(tree);
    case Kind::divide:
      return joined(tree, "/", Level::product, Level::with_sign);
    case Kind::power:
      return raised(tree);
    case Kind::call:
      break;
  }
  return called(tree);
}

}  // namespace

std::string text_of(std::mt19937& random, const Tree& tree, Calls calls) {
  return Speller(random, calls).spell(tree).text;
}

}  // namespace kinestat::sample
