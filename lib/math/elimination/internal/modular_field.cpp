#include "math/elimination/internal/modular_field.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/contract.hpp"

namespace kinestat {

PrimeField::Value residue_of(double value, const PrimeField& field) {
  KINESTAT_EXPECTS(std::isfinite(value));
  int exponent = 0;
  constexpr int kBits = std::numeric_limits<double>::digits;
  auto whole =
      static_cast<PrimeField::Value>(std::ldexp(std::frexp(std::abs(value), &exponent), kBits));
  if (whole == 0) {
    return 0;
  }
  whole >>= static_cast<unsigned>(std::countr_zero(whole));
  exponent -= static_cast<int>(std::bit_width(whole));
  const PrimeField::Value half = (field.modulus() + 1) / 2;
  const PrimeField::Value result = field.product(
      whole, field.power(exponent < 0 ? half : 2, static_cast<std::uint64_t>(std::abs(exponent))));
  return value < 0.0 ? field.difference(0, result) : result;
}

}  // namespace kinestat
