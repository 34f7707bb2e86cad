// Residues modulo 2^61 - 1, whose products need no division.
#pragma once

#include <compare>
#include <cstdint>

namespace kinestat {

/// What is zero for all values of some unknowns is zero for drawn ones; what is not, is by chance:
/// a polynomial of degree d with a probability of d/2^61 at most (Schwartz 1980).
class MersenneResidue {
 public:
  static constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61U) - 1;

  constexpr MersenneResidue() = default;

  constexpr explicit MersenneResidue(std::uint64_t value) : value_(value % kPrime) {}

  constexpr std::uint64_t value() const { return value_; }

  constexpr bool is_zero() const { return value_ == 0; }

  constexpr auto operator<=>(const MersenneResidue&) const = default;

  constexpr MersenneResidue& operator+=(MersenneResidue b) {
    value_ += b.value_;
    value_ = value_ >= kPrime ? value_ - kPrime : value_;
    return *this;
  }

  constexpr MersenneResidue& operator-=(MersenneResidue b) {
    value_ += kPrime - b.value_;
    value_ = value_ >= kPrime ? value_ - kPrime : value_;
    return *this;
  }

  constexpr MersenneResidue& operator*=(MersenneResidue b) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = static_cast<Wide>(value_) * b.value_;
    value_ =
        static_cast<std::uint64_t>(product & kPrime) + static_cast<std::uint64_t>(product >> 61U);
    value_ = value_ >= kPrime ? value_ - kPrime : value_;
    return *this;
  }

  friend constexpr MersenneResidue operator+(MersenneResidue a, MersenneResidue b) {
    return a += b;
  }

  friend constexpr MersenneResidue operator-(MersenneResidue a, MersenneResidue b) {
    return a -= b;
  }

  friend constexpr MersenneResidue operator*(MersenneResidue a, MersenneResidue b) {
    return a *= b;
  }

  constexpr MersenneResidue operator-() const { return MersenneResidue() - *this; }

  /// Of a number that is not zero (Fermat).
  constexpr MersenneResidue inverse() const {
    MersenneResidue result(1);
    MersenneResidue power = *this;
    for (std::uint64_t exponent = kPrime - 2; exponent != 0; exponent >>= 1U) {
      if ((exponent & 1U) != 0) {
        result *= power;
      }
      power *= power;
    }
    return result;
  }

 private:
  std::uint64_t value_ = 0;
};

}  // namespace kinestat
