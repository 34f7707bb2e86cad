// What Eigen must know of a type of number that has + - * / and nothing more.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// Set to true for the types that get += -= *= /= from here.
template <class Number>
inline constexpr bool kHasPlainArithmetic = false;

template <class Number>
concept PlainNumber = kHasPlainArithmetic<Number>;

template <PlainNumber Number>
Number& operator+=(Number& a, const Number& b) {
  return a = a + b;
}

template <PlainNumber Number>
Number& operator-=(Number& a, const Number& b) {
  return a = a - b;
}

template <PlainNumber Number>
Number& operator*=(Number& a, const Number& b) {
  return a = a * b;
}

template <PlainNumber Number>
Number& operator/=(Number& a, const Number& b) {
  return a = a / b;
}

/// Eigen::NumTraits of such a type; costs are in operations of doubles.
template <class Number, int kReadCost, int kOperationCost>
struct EigenNumber : Eigen::GenericNumTraits<Number> {
  using Real = Number;
  using NonInteger = Number;
  using Nested = Number;
  using Literal = double;

  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = kReadCost,
    AddCost = kOperationCost,
    MulCost = kOperationCost
  };
};

}  // namespace kinestat
