#include "math/exact_rank.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/contract.hpp"
#include "math/internal/field_eliminator.hpp"
#include "math/internal/rational_field.hpp"

namespace kinestat {

namespace {

// Any number will do: what matters is that no matrix was made for the primes it leads to.
constexpr std::uint64_t kFirstSeed = 20261121;

constexpr int kPrimes = 2;

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

std::optional<PrimeField::Value> image(const Rational& value, const PrimeField& field) {
  return field.residue(value);
}

std::optional<PrimeField::Value> image(const RootSum& value, const PrimeField& field) {
  return value.residue(field);
}

// Empty if the prime divides a denominator.
template <class Matrix>
std::optional<int> modular_rank(const Matrix& matrix, const PrimeField& field) {
  FieldElimination<PrimeField> elimination{.field = field};
  bool has_image = true;
  elimination.load(matrix.rows, matrix.entries, [&](const auto& value) {
    const std::optional<PrimeField::Value> residue = image(value, field);
    has_image = has_image && residue.has_value();
    return residue.value_or(0);
  });
  if (!has_image) {
    return std::nullopt;
  }
  FieldEliminator(elimination).run(matrix.columns, {});
  return elimination.rank();
}

template <class Field, class Matrix>
int eliminated_rank(const Matrix& matrix) {
  FieldElimination<Field> elimination{.field = {}};
  elimination.load(matrix.rows, matrix.entries, [](const auto& value) { return value; });
  FieldEliminator(elimination).run(matrix.columns, {});
  return elimination.rank();
}

double bits(const Integer& value) {
  return value.is_zero() ? 0.0 : static_cast<double>(msb(abs(value))) + 1.0;
}

// Of the norm of any minor, its rows multiplied with their denominators: no conjugate of a row is
// larger than the sum of the sizes of its coefficients (Hadamard), and there are φ(N) conjugates.
double bits_of_largest_norm(const RootMatrix& matrix) {
  std::vector<Rational> size(static_cast<std::size_t>(matrix.rows));
  std::vector<Integer> denominator(size.size(), Integer(1));
  for (const RootEntry& entry : matrix.entries) {
    for (const auto& [k, factor] : entry.value.terms()) {
      at(size, entry.row) += abs(factor);
      Integer& common = at(denominator, entry.row);
      common = lcm(common, boost::multiprecision::denominator(factor));
    }
  }
  double sum = 0.0;
  for (std::size_t r = 0; r < size.size(); ++r) {
    const Rational whole = size[r] * denominator[r];
    sum += bits(boost::multiprecision::numerator(whole));
  }
  return sum * totient(matrix.root_count);
}

// The rank is larger only if a prime divides the norm of a minor, which has room for so many.
double error_probability(const RootMatrix& matrix, const PrimeField& field) {
  constexpr double kLeastBits = 60.0;
  return std::min(1.0, bits_of_largest_norm(matrix) / kLeastBits / field.prime_count());
}

bool reaches(int rank, int upper_bound) {
  KINESTAT_EXPECTS(rank <= upper_bound);
  return rank == upper_bound;
}

}  // namespace

std::string_view text_of(RankProof proof) {
  switch (proof) {
    case RankProof::structural:
      return "structural bound";
    case RankProof::elimination:
      return "exact elimination";
    case RankProof::modular:
      return "modulo two primes";
  }
  return "";
}

ExactRank find_exact_rank(const ExactMatrix& matrix, int upper_bound) {
  const PrimeField field(1, kFirstSeed);
  const int lower = modular_rank(matrix, field).value_or(0);
  if (reaches(lower, upper_bound)) {
    return {.rank = lower, .proof = RankProof::structural, .error_probability = 0.0};
  }
  return {.rank = eliminated_rank<RationalField>(matrix),
          .proof = RankProof::elimination,
          .error_probability = 0.0};
}

ExactRank find_exact_rank(const RootMatrix& matrix, int upper_bound) {
  ExactRank result{.rank = 0, .proof = RankProof::structural, .error_probability = 1.0};
  for (int i = 0; i < kPrimes; ++i) {
    const PrimeField field(matrix.root_count, kFirstSeed + static_cast<std::uint64_t>(i));
    const std::optional<int> rank = modular_rank(matrix, field);
    result.rank = std::max(result.rank, rank.value_or(0));
    result.error_probability *= rank ? error_probability(matrix, field) : 1.0;
    if (reaches(result.rank, upper_bound)) {
      result.error_probability = 0.0;
      return result;
    }
  }
  if (totient(matrix.root_count) <= kLargestDegree) {
    return {.rank = eliminated_rank<RootField>(matrix),
            .proof = RankProof::elimination,
            .error_probability = 0.0};
  }
  result.proof = RankProof::modular;
  return result;
}

}  // namespace kinestat
