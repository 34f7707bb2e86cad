// Minors of the equations of planetary sets, of which all speeds of a transmission are sums.
//
// A set says c_0 w_0 + c_1 w_1 + c_2 w_2 = 0 of its three shafts. Elements that are engaged merge
// shafts; what is left turns in one way, and the speed of a merged shaft is, up to its sign, the
// determinant of the equations without its column (Cramer). A column of merged shafts is the sum of
// theirs, so that this determinant is the sum of minors of the sets alone, one for each choice of a
// shaft out of every other merged one. The minors are made once for all gears; as each set has one
// row, all are affine in each stationary ratio, and so is every speed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "studies/transmissions/structure.hpp"

namespace kinestat {

inline constexpr int kMostShafts = kMostGearSets + kMostEngaged + 2;

using ShaftPair = std::array<Shaft, 2>;

/// A minor that is added or subtracted.
struct MinorTerm {
  std::uint8_t minor = 0;
  bool is_negative = false;
};

/// Which shafts turn as one while shafts are joined: of each the number of what it belongs to, from
/// 0, the housing, in the order of the first shafts.
class MergedShafts {
 public:
  /// Empty if pairs close a ring: one of them says nothing.
  static std::optional<MergedShafts> merge(int shafts, std::span<const ShaftPair> joined);

  int of(Shaft shaft) const { return group_[shaft]; }

  int count() const { return count_; }

  int shafts() const { return shafts_; }

 private:
  std::array<int, kMostShafts> group_{};
  int shafts_ = 0;
  int count_ = 0;
};

/// Coefficients of a set's equation by the place of the shaft.
template <class Number>
using SetEquation = std::array<Number, 3>;

class SetMinors {
 public:
  explicit SetMinors(const TransmissionStructure& structure);

  std::size_t count() const { return count_; }

  /// The terms of the speed of merged shafts `group`, which are sets + 2 with the housing; none for
  /// the housing, and for what rests always.
  std::vector<MinorTerm> speed_terms(const MergedShafts& merged, int group) const;

  /// All minors for numbers of any kind.
  template <class Number>
  void evaluate(std::span<const SetEquation<Number>> equations, std::span<Number> minors) const {
    std::array<Number, kMostProducts> products;
    products[0] = Number(1);
    std::size_t made = 1;
    for (const SetEquation<Number>& equation : equations) {
      for (std::size_t i = made; i-- > 0;) {
        const Number left = products[i];
        for (std::size_t t = 0; t < 3; ++t) {
          products[3 * i + t] = left * equation[t];
        }
      }
      made *= 3;
    }
    for (Number& minor : minors) {
      minor = Number(0);
    }
    for (const Product& one : products_) {
      Number& minor = minors[one.minor];
      minor = one.is_negative ? minor - products[one.product] : minor + products[one.product];
    }
  }

  /// The sum of minors.
  template <class Number>
  static Number sum(std::span<const MinorTerm> terms, std::span<const Number> minors) {
    Number result(0);
    for (const MinorTerm& term : terms) {
      result = term.is_negative ? result - minors[term.minor] : result + minors[term.minor];
    }
    return result;
  }

  /// A product of coefficients, one of each set, and the minor of which it is a term.
  struct Product {
    std::uint8_t product = 0;  ///< places as digits to the base 3, the last set's the last
    std::uint8_t minor = 0;
    bool is_negative = false;
  };

  std::span<const Product> products() const { return products_; }

 private:
  static constexpr std::size_t kMostProducts = 81;  // 3^kMostGearSets
  static constexpr std::uint8_t kNoMinor = 0xff;

  int sets_;
  std::size_t count_ = 0;
  std::vector<std::uint8_t> minor_of_;  // by the bits of its shafts
  std::vector<Product> products_;
};

}  // namespace kinestat
