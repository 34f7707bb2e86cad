#include "math/elimination/internal/null_vector_proof.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace kinestat {

namespace {

using Value = ModularField::Value;
using ModularElimination = FieldElimination<ModularField>;

constexpr std::size_t kMostVectors = 16;

// p has 61 bits. A residue belongs to one fraction at most with numerator and denominator up to the
// root of p/2.
constexpr std::uint64_t kLargestPart = std::uint64_t{1} << 29U;
constexpr std::uint64_t kLargestDenominator = std::uint64_t{1} << 60U;

// A few sums of doubles may be rounded down by less than that.
constexpr double kRoom = 2.0;

struct Fraction {
  double numerator = 0.0;  // its size
  std::uint64_t denominator = 1;
};

// The steps of Euclid's algorithm for p and the residue, until the remainder is small: it is the
// numerator (Wang 1981).
std::optional<Fraction> fraction_of(Value residue, Value p) {
  if (residue <= kLargestPart || p - residue <= kLargestPart) {
    return Fraction{.numerator = static_cast<double>(std::min(residue, p - residue))};
  }
  Value before = p;
  Value rest = residue;
  std::uint64_t factor_before = 0;  // of the residue in each remainder, without its sign
  std::uint64_t factor = 1;
  while (rest > kLargestPart) {
    const Value times = before / rest;
    const Value next = before % rest;
    const std::uint64_t next_factor = factor_before + times * factor;
    before = rest;
    rest = next;
    factor_before = factor;
    factor = next_factor;
    if (factor > kLargestPart) {
      return std::nullopt;
    }
  }
  return Fraction{.numerator = static_cast<double>(rest), .denominator = factor};
}

// All with one division (Montgomery).
std::vector<Value> reciprocals_of_pivots(const ModularElimination& elimination) {
  const ModularField& field = elimination.field;
  std::vector<Value> result(elimination.pivots.size());
  Value product = 1;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = product;
    product = field.product(product, elimination.pivots[i].value);
  }
  Value reciprocal = field.prime.quotient(1, product);
  for (std::size_t i = result.size(); i-- > 0;) {
    result[i] = field.product(result[i], reciprocal);
    reciprocal = field.product(reciprocal, elimination.pivots[i].value);
  }
  return result;
}

// 1 at the free column, 0 at the others.
std::vector<Value> null_vector(const ModularElimination& elimination,
                               const std::vector<Value>& reciprocals,
                               int free_column,
                               int columns) {
  const ModularField& field = elimination.field;
  std::vector<Value> x(static_cast<std::size_t>(columns), 0);
  at(x, free_column) = 1;
  for (std::size_t i = reciprocals.size(); i-- > 0;) {
    const ModularElimination::Pivot& pivot = elimination.pivots[i];
    Value sum = 0;
    for (const ModularElimination::Cell& cell : at(elimination.rows, pivot.row)) {
      const Value factor = at(x, cell.column);
      if (factor != 0) {
        field.subtract_product(sum, cell.value, factor);
      }
    }
    at(x, pivot.column) = sum == 0 ? 0 : field.product(sum, reciprocals[i]);
  }
  return x;
}

// The least common multiple; 0 beyond kLargestDenominator, and of 0.
std::uint64_t common_multiple(std::uint64_t a, std::uint64_t b) {
  if (a == b || b == 1) {
    return a;
  }
  if (b == 0) {
    return 0;
  }
  const std::uint64_t factor = b / std::gcd(a, b);
  return a <= kLargestDenominator / factor ? a * factor : 0;
}

// Of the terms of an equation: the sum of their sizes and the denominators on both sides.
struct Equation {
  double size = 0.0;
  std::uint64_t of_entries = 1;
  std::uint64_t of_vector = 1;
};

bool vector_holds(const std::vector<Value>& x,
                  const std::vector<EntrySize>& entries,
                  std::size_t row_count,
                  Value p) {
  std::vector<Fraction> fractions;
  fractions.reserve(x.size());
  for (const Value one : x) {
    const std::optional<Fraction> fraction = fraction_of(one, p);
    if (!fraction) {
      return false;
    }
    fractions.push_back(*fraction);
  }
  std::vector<Equation> equations(row_count);
  for (const EntrySize& entry : entries) {
    const Fraction& factor = at(fractions, entry.column);
    if (factor.numerator == 0.0) {
      continue;
    }
    Equation& equation = at(equations, entry.row);
    equation.size += entry.size * factor.numerator / static_cast<double>(factor.denominator);
    equation.of_entries = common_multiple(equation.of_entries, entry.denominator);
    equation.of_vector = common_multiple(equation.of_vector, factor.denominator);
    if (equation.of_entries == 0 || equation.of_vector == 0) {
      return false;
    }
  }
  return std::ranges::all_of(equations, [&](const Equation& one) {
    const double whole =
        one.size * static_cast<double>(one.of_entries) * static_cast<double>(one.of_vector) * kRoom;
    return whole < static_cast<double>(p);
  });
}

}  // namespace

bool null_vectors_hold(const ModularElimination& elimination,
                       const std::vector<EntrySize>& entries,
                       int columns) {
  if (elimination.free_columns.size() > kMostVectors) {
    return false;
  }
  const std::vector<Value> reciprocals = reciprocals_of_pivots(elimination);
  return std::ranges::all_of(elimination.free_columns, [&](int column) {
    return vector_holds(null_vector(elimination, reciprocals, column, columns),
                        entries,
                        elimination.rows.size(),
                        elimination.field.prime.modulus());
  });
}

}  // namespace kinestat
