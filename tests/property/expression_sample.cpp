// The generator of random trees.
#include "property/expression_sample.hpp"

#include <utility>

namespace kinestat::sample {

namespace {

constexpr Powers kBare = {0, 0, 0, 0};
constexpr Powers kLength = {1, 0, 0, 0};

class Generator {
 public:
  explicit Generator(std::mt19937& random) : random_(random) {}

  Tree make(const Powers& powers, int depth);

 private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  Powers any_powers();
  Tree operand(const Powers& powers, int depth);
  Tree leaf(const Powers& powers);
  Tree literal(int largest);
  Tree measure(const Powers& powers);
  Tree bare(int depth);
  Tree angle(int depth);
  Tree any(const Powers& powers, int depth);
  Tree product(const Powers& powers, int depth);
  Tree quotient(const Powers& powers, int depth);
  Tree raised(const Powers& powers, int depth);

  std::mt19937& random_;
};

Tree node(Kind kind, std::vector<Tree> parts) {
  return {.kind = kind, .word = {}, .parts = std::move(parts)};
}

Tree word(Kind kind, std::string text) {
  return {.kind = kind, .word = std::move(text), .parts = {}};
}

Tree call(std::string name, std::vector<Tree> values) {
  return {.kind = Kind::call, .word = std::move(name), .parts = std::move(values)};
}

Tree whole(int value) {
  return {.kind = Kind::literal, .digits = value, .word = {}, .parts = {}};
}

Powers joined_powers(const Powers& a, const Powers& b, int sign) {
  Powers result = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result[i] += sign * b[i];
  }
  return result;
}

bool is_multiple(const Powers& powers, int factor) {
  return powers[0] % factor == 0 && powers[1] % factor == 0 && powers[2] % factor == 0 &&
         powers[3] % factor == 0;
}

Powers scaled(Powers powers, int multiplier, int divisor) {
  for (int& power : powers) {
    power = power * multiplier / divisor;
  }
  return powers;
}

Tree Generator::make(const Powers& powers, int depth) {
  if (depth <= 0) {
    return leaf(powers);
  }
  if (powers == kBare && pick(2) == 0) {
    return bare(depth - 1);
  }
  if (powers == kAngle && pick(4) == 0) {
    return angle(depth - 1);
  }
  return any(powers, depth - 1);
}

Powers Generator::any_powers() {
  static const std::vector<Powers> kChoices = {
      kBare, kBare, kLength, kAngle, {0, 0, 1, 0}, {0, 1, 0, 0}, {1, 1, -2, 0}, {2, 1, -2, 0}};
  return kChoices[static_cast<std::size_t>(pick(static_cast<int>(kChoices.size())))];
}

// Once in eighty operands of the wrong dimension.
Tree Generator::operand(const Powers& powers, int depth) {
  return make(pick(80) == 0 ? any_powers() : powers, depth);
}

Tree Generator::literal(int largest) {
  const int decimals = pick(2) == 0 ? 0 : pick(4);
  return {.kind = Kind::literal,
          .digits = pick(largest + 1),
          .decimals = decimals,
          .word = {},
          .parts = {}};
}

Tree Generator::leaf(const Powers& powers) {
  std::vector<std::string> fitting;
  for (const NameRow& row : names()) {
    if (row.powers == powers) {
      fitting.emplace_back(row.name);
    }
  }
  if (!fitting.empty() && pick(2) == 0) {
    return word(Kind::name,
                fitting[static_cast<std::size_t>(pick(static_cast<int>(fitting.size())))]);
  }
  if (powers == kBare) {
    return pick(12) == 0 ? word(Kind::pi, "pi") : literal(pick(2) == 0 ? 12 : 999);
  }
  if (powers == kAngle && pick(3) == 0) {
    return node(Kind::multiply, {whole(15 * pick(25)), word(Kind::unit, "deg")});
  }
  return measure(powers);
}

// A number times units, which are chosen until nothing of the dimension is left.
Tree Generator::measure(const Powers& powers) {
  std::vector<const UnitRow*> fitting;
  for (const UnitRow& row : units()) {
    if (row.powers == powers) {
      fitting.push_back(&row);
    }
  }
  if (!fitting.empty()) {
    const UnitRow* row = fitting[static_cast<std::size_t>(pick(static_cast<int>(fitting.size())))];
    return node(Kind::multiply, {literal(999), word(Kind::unit, row->name)});
  }
  static const std::array<std::vector<std::string>, 4> kBases = {
      {{"mm", "m", "in"}, {"kg", "g"}, {"s", "min", "h"}, {"deg", "rad", "rev"}}};
  Tree result = literal(999);
  for (std::size_t i = 0; i < powers.size(); ++i) {
    const auto choice = static_cast<std::size_t>(pick(static_cast<int>(kBases[i].size())));
    for (int k = 0; k < std::abs(powers[i]); ++k) {
      const Kind kind = powers[i] > 0 ? Kind::multiply : Kind::divide;
      result = node(kind, {std::move(result), word(Kind::unit, kBases[i][choice])});
    }
  }
  return result;
}

Tree Generator::bare(int depth) {
  static const std::vector<std::string> kOfAngle = {"sin", "cos", "tan"};
  static const std::vector<std::string> kOfNumber = {
      "floor", "ceil", "round", "exp", "log", "ln", "log10"};
  switch (pick(4)) {
    case 0:
      return call(kOfAngle[static_cast<std::size_t>(pick(3))], {operand(kAngle, depth)});
    case 1:
      return call("gcd", {whole(pick(60)), pick(3) == 0 ? operand(kBare, depth) : whole(pick(60))});
    default:
      return call(kOfNumber[static_cast<std::size_t>(pick(7))], {operand(kBare, depth)});
  }
}

Tree Generator::angle(int depth) {
  static const std::vector<std::string> kOfNumber = {"asin", "acos", "atan"};
  if (pick(2) == 0) {
    const Powers powers = any_powers();
    return call("atan2", {operand(powers, depth), operand(powers, depth)});
  }
  return call(kOfNumber[static_cast<std::size_t>(pick(3))], {operand(kBare, depth)});
}

Tree Generator::any(const Powers& powers, int depth) {
  static const std::vector<std::string> kOfTwo = {"min", "max", "mod", "hypot"};
  switch (pick(12)) {
    case 0:
    case 1:
      return node(Kind::add, {operand(powers, depth), operand(powers, depth)});
    case 2:
    case 3:
      return node(Kind::subtract, {operand(powers, depth), operand(powers, depth)});
    case 4:
      return node(Kind::negate, {operand(powers, depth)});
    case 5:
      return call("abs", {operand(powers, depth)});
    case 6:
      return call(kOfTwo[static_cast<std::size_t>(pick(4))],
                  {operand(powers, depth), operand(powers, depth)});
    case 7:
    case 8:
      return product(powers, depth);
    case 9:
      return quotient(powers, depth);
    case 10:
      return call("sqrt", {operand(scaled(powers, 2, 1), depth)});
    default:
      return raised(powers, depth);
  }
}

Tree Generator::product(const Powers& powers, int depth) {
  const Powers left = any_powers();
  return node(Kind::multiply,
              {operand(left, depth), operand(joined_powers(powers, left, -1), depth)});
}

Tree Generator::quotient(const Powers& powers, int depth) {
  const Powers right = any_powers();
  return node(Kind::divide,
              {operand(joined_powers(powers, right, 1), depth), operand(right, depth)});
}

Tree Generator::raised(const Powers& powers, int depth) {
  const int exponent = pick(3) + 1;
  if (powers == kBare && pick(3) == 0) {
    return node(Kind::power, {operand(kBare, depth), literal(30)});
  }
  if (powers == kBare && pick(3) == 0) {
    return node(Kind::power, {operand(kBare, depth), node(Kind::negate, {whole(exponent)})});
  }
  if (is_multiple(powers, exponent)) {
    return node(Kind::power, {operand(scaled(powers, 1, exponent), depth), whole(exponent)});
  }
  return leaf(powers);
}

}  // namespace

const std::vector<UnitRow>& units() {
  static const std::vector<UnitRow> kRows = {
      {"m", 1, 1, 0, kLength},         {"mm", 1, 1000, 0, kLength},
      {"um", 1, 1000000, 0, kLength},  {"cm", 1, 100, 0, kLength},
      {"km", 1000, 1, 0, kLength},     {"in", 254, 10000, 0, kLength},
      {"rad", 1, 1, 0, kAngle},        {"deg", 1, 180, 1, kAngle},
      {"rev", 2, 1, 1, kAngle},        {"s", 1, 1, 0, {0, 0, 1, 0}},
      {"min", 60, 1, 0, {0, 0, 1, 0}}, {"h", 3600, 1, 0, {0, 0, 1, 0}},
      {"kg", 1, 1, 0, {0, 1, 0, 0}},   {"g", 1, 1000, 0, {0, 1, 0, 0}},
      {"N", 1, 1, 0, {1, 1, -2, 0}},   {"kN", 1000, 1, 0, {1, 1, -2, 0}},
      {"Nm", 1, 1, 0, {2, 1, -2, 0}},  {"rpm", 2, 60, 1, {0, 0, -1, 1}},
      {"W", 1, 1, 0, {2, 1, -3, 0}},   {"kW", 1000, 1, 0, {2, 1, -3, 0}}};
  return kRows;
}

const std::vector<NameRow>& names() {
  static const std::vector<NameRow> kRows = {{"ratio", 1250, kBare},
                                             {"teeth", 24000, kBare},
                                             {"crank", 75, kLength},
                                             {"turned", 400, kAngle},
                                             {"load", 12500, {1, 1, -2, 0}}};
  return kRows;
}

Tree make_tree(std::mt19937& random, const Powers& powers, int depth) {
  return Generator(random).make(powers, depth);
}

}  // namespace kinestat::sample
