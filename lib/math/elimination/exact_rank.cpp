#include "math/elimination/exact_rank.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "core/contract.hpp"
#include "math/elimination/internal/null_vector_proof.hpp"
#include "math/elimination/internal/rational_field.hpp"
#include "math/elimination/internal/row_eliminator.hpp"

namespace kinestat {

namespace {

// Any number will do: what matters is that no matrix was made for the primes it leads to.
constexpr std::uint64_t kFirstSeed = 20261121;

constexpr int kPrimes = 2;

// Products of fractions that an exact elimination may take: some seconds. The elimination modulo a
// prime tells how many they will be.
constexpr double kMostProducts = 1 << 23;

// Fields of roots of unity; the reciprocal of a pivot serves all rows below it.
struct RootField {
  using Value = RootSum;

  static bool is_zero(const RootSum& a) { return a.is_zero(); }

  RootSum quotient(const RootSum& a, const RootSum& b) {
    if (!(b == divisor_)) {
      divisor_ = b;
      reciprocal_ = b.inverse();
    }
    return a * reciprocal_;
  }

  static void add(RootSum& a, const RootSum& b) { a += b; }

  static void subtract_product(RootSum& a, const RootSum& b, const RootSum& c) { a -= b * c; }

  RootSum divisor_;
  RootSum reciprocal_;
};

std::optional<PrimeField::Value> image(double value, const PrimeField& field) {
  return residue_of(value, field);
}

std::optional<PrimeField::Value> image(const Rational& value, const PrimeField& field) {
  return field.residue(value);
}

std::optional<PrimeField::Value> image(const RootSum& value, const PrimeField& field) {
  return value.residue(field);
}

template <class Number>
struct TurnedEntry {
  int row = 0;
  int column = 0;
  const Number* value = nullptr;
};

// A matrix, or its transpose, so that it has no more columns than rows; the rank is the same. It
// points into the matrix.
template <class Number>
struct UprightMatrix {
  int rows = 0;
  int columns = 0;
  std::vector<TurnedEntry<Number>> entries;
};

template <class Matrix>
auto upright(const Matrix& matrix) {
  using Number = std::remove_cvref_t<decltype(matrix.entries.front().value)>;
  const bool is_wide = matrix.columns > matrix.rows;
  UprightMatrix<Number> result{.rows = std::max(matrix.rows, matrix.columns),
                               .columns = std::min(matrix.rows, matrix.columns),
                               .entries = {}};
  result.entries.reserve(matrix.entries.size());
  for (const auto& entry : matrix.entries) {
    result.entries.push_back({.row = is_wide ? entry.column : entry.row,
                              .column = is_wide ? entry.row : entry.column,
                              .value = &entry.value});
  }
  return result;
}

using ModularElimination = FieldElimination<ModularField>;

// Empty if the prime divides a denominator.
template <class Number>
std::optional<ModularElimination> eliminate_modulo(const UprightMatrix<Number>& matrix,
                                                   const PrimeField& field) {
  ModularElimination elimination{.field = {.prime = field}};
  bool has_image = true;
  elimination.load(matrix.rows, matrix.entries, [&](const Number* value) {
    const std::optional<PrimeField::Value> residue = image(*value, field);
    has_image = has_image && residue.has_value();
    return residue.value_or(0);
  });
  if (!has_image) {
    return std::nullopt;
  }
  RowEliminator(elimination, matrix.columns).run();
  return elimination;
}

template <class Field, class Number>
int eliminated_rank(const UprightMatrix<Number>& matrix) {
  FieldElimination<Field> elimination{.field = {}};
  elimination.load(matrix.rows, matrix.entries, [](const Number* value) { return *value; });
  RowEliminator(elimination, matrix.columns).run();
  return elimination.rank();
}

// A double is a whole number of 53 bits times a power of two.
EntrySize size_of(double value) {
  int exponent = 0;
  auto whole = static_cast<std::uint64_t>(
      std::ldexp(std::frexp(std::abs(value), &exponent), std::numeric_limits<double>::digits));
  exponent += std::countr_zero(whole) - std::numeric_limits<double>::digits;
  constexpr int kMostBits = 60;
  EntrySize result{.size = std::abs(value)};
  if (exponent < 0) {
    result.denominator = exponent < -kMostBits ? 0 : std::uint64_t{1} << -exponent;
  }
  return result;
}

std::vector<EntrySize> sizes_of(const UprightMatrix<double>& matrix) {
  std::vector<EntrySize> sizes;
  sizes.reserve(matrix.entries.size());
  for (const TurnedEntry<double>& entry : matrix.entries) {
    sizes.push_back(size_of(*entry.value));
    sizes.back().row = entry.row;
    sizes.back().column = entry.column;
  }
  return sizes;
}

double bits(const Integer& value) {
  return value.is_zero() ? 0.0 : static_cast<double>(msb(abs(value))) + 1.0;
}

// Calls `visit` with the coefficients of a number.
template <class Visit>
void for_each_coefficient(const Rational& value, const Visit& visit) {
  visit(value);
}

template <class Visit>
void for_each_coefficient(const RootSum& value, const Visit& visit) {
  for (const auto& [k, factor] : value.terms()) {
    visit(factor);
  }
}

// Of any minor, its rows multiplied with their denominators, and of its conjugates: none of a row
// is larger than the sum of the sizes of its coefficients (Hadamard).
template <class Matrix>
double bits_of_largest_minor(const Matrix& matrix) {
  std::vector<Rational> size(static_cast<std::size_t>(matrix.rows));
  std::vector<Integer> denominator(size.size(), Integer(1));
  for (const auto& entry : matrix.entries) {
    for_each_coefficient(entry.value, [&](const Rational& factor) {
      at(size, entry.row) += abs(factor);
      Integer& common = at(denominator, entry.row);
      common = lcm(common, boost::multiprecision::denominator(factor));
    });
  }
  double sum = 0.0;
  for (std::size_t r = 0; r < size.size(); ++r) {
    sum += bits(boost::multiprecision::numerator(Rational(size[r] * denominator[r])));
  }
  return sum;
}

// The rank is larger only if the prime divides the norm of a minor, the product of its conjugates:
// there is room for so many of all primes that might have been drawn.
double error_probability(double bits_of_norm, const PrimeField& field) {
  constexpr double kLeastBits = 60.0;
  return std::min(1.0, bits_of_norm / kLeastBits / field.prime_count());
}

bool reaches(int rank, int upper_bound) {
  KINESTAT_EXPECTS(rank <= upper_bound);
  return rank == upper_bound;
}

// `degree` fractions make a number of the Field, which has so many conjugates.
template <class Field, class Matrix>
ExactRank rank_of(const Matrix& matrix, int root_count, int degree, int upper_bound) {
  ExactRank result{.rank = 0, .proof = RankProof::structural, .error_probability = 1.0};
  const auto turned = upright(matrix);
  std::int64_t products = 0;
  for (int i = 0; i < kPrimes; ++i) {
    const PrimeField field(root_count, kFirstSeed + static_cast<std::uint64_t>(i));
    const std::optional<ModularElimination> found = eliminate_modulo(turned, field);
    if (!found) {
      continue;
    }
    result.rank = std::max(result.rank, found->rank());
    products = std::max(products, found->products);
    if (reaches(result.rank, upper_bound)) {
      result.error_probability = 0.0;
      return result;
    }
    result.error_probability *= error_probability(bits_of_largest_minor(matrix) * degree, field);
  }
  const double fractions = static_cast<double>(products) * degree * degree;
  if (degree > kLargestDegree || fractions > kMostProducts) {
    result.proof = RankProof::modular;
    return result;
  }
  return {.rank = eliminated_rank<Field>(turned),
          .proof = RankProof::elimination,
          .error_probability = 0.0};
}

}  // namespace

std::string_view text_of(RankProof proof) {
  switch (proof) {
    case RankProof::structural:
      return "structural bound";
    case RankProof::elimination:
      return "exact elimination";
    case RankProof::null_vectors:
      return "exact null vectors";
    case RankProof::modular:
      return "modulo two primes";
  }
  return "";
}

ExactRank find_exact_rank(const SparseMatrix& matrix, int upper_bound) {
  const UprightMatrix<double> turned = upright(matrix);
  const std::optional<ModularElimination> found =
      eliminate_modulo(turned, PrimeField(1, kFirstSeed));
  if (found && reaches(found->rank(), upper_bound)) {
    return {.rank = found->rank(), .proof = RankProof::structural};
  }
  if (found && null_vectors_hold(*found, sizes_of(turned), turned.columns)) {
    return {.rank = found->rank(), .proof = RankProof::null_vectors};
  }
  return find_exact_rank(exact_matrix(matrix), upper_bound);
}

ExactRank find_exact_rank(const ExactMatrix& matrix, int upper_bound) {
  return rank_of<RationalField>(matrix, 1, 1, upper_bound);
}

ExactRank find_exact_rank(const RootMatrix& matrix, int upper_bound) {
  return rank_of<RootField>(matrix, matrix.root_count, totient(matrix.root_count), upper_bound);
}

}  // namespace kinestat
