// Functions of one argument as polynomials between places, found by looking at few of their values.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// Points and weights of the rule of Gauss and Legendre on [-1, 1], which integrates polynomials up
/// to degree 2 n - 1 exactly.
struct GaussPoints {
  VecX points;
  VecX weights;
};

GaussPoints gauss_points(int count);

/// The values of some functions at a place, and how large what they are made of is there.
struct FunctionValues {
  VecX values;
  VecX sizes;
};

/// Empty where there are none.
using FunctionsAt = std::function<std::optional<FunctionValues>(double argument)>;

/// Where a value is greatest.
struct GreatestValue {
  double value = 0.0;
  double argument = 0.0;
};

/// Several functions on one range. Between its places each is the polynomial through its values at
/// the points of Gauss, whose last terms are small against the size of the function.
class LegendrePieces {
 public:
  struct Piece {
    double from = 0.0;
    double to = 0.0;
    MatX values;        ///< a row for each point of Gauss, a column for each function
    MatX coefficients;  ///< of the polynomials of Legendre, likewise
    double tail = 0.0;  ///< the last terms, as share of the largest size
  };

  /// How fine it may become.
  struct Limits {
    double tail = 0.0;     ///< what the last terms may be, as share of the largest size
    double noise = 0.0;    ///< below this they are rounding where halves have them as large
    double finest = 0.0;   ///< the least piece, as share of the range: where a function jumps
    std::size_t most = 0;  ///< pieces
  };

  /// Between these places first, then between halves where the functions ask for it. Empty where
  /// some point has no values, the pieces would be too many, or rounding is larger than that noise.
  static std::optional<LegendrePieces> find(const FunctionsAt& functions,
                                            std::span<const double> places,
                                            const Limits& limits);

  const std::vector<Piece>& pieces() const { return pieces_; }

  double from() const { return pieces_.front().from; }

  double to() const { return pieces_.back().to; }

  /// The largest size of a function.
  double size(std::size_t function) const { return sizes_[static_cast<Eigen::Index>(function)]; }

  double value(std::size_t function, double argument) const;

  VecX values(double argument) const;

  /// From the begin of the range up to there.
  double integral(std::size_t function, double argument) const;

  double integral(std::size_t function) const { return integral(function, to()); }

  /// Takes an argument, the weight of it in an integral over the range, and the values there.
  using AtPoint = std::function<void(double argument, double weight, const VecX& values)>;

  /// At the points of Gauss, of pieces that are no wider than that.
  void for_each_point(double widest, const AtPoint& take) const;

  /// Of a function that is smooth where these are; of equal peaks the first.
  GreatestValue greatest(const std::function<double(double argument)>& value) const;

 private:
  const Piece& piece_at(double argument) const;

  std::vector<Piece> pieces_;
  std::vector<VecX> begun_;  // of each piece: integrals up to its begin
  VecX sizes_;
};

}  // namespace kinestat
