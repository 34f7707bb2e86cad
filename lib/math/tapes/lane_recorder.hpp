// Arithmetic with numbers of which the values come later: it is noted down for a LaneTape.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "math/tapes/internal/tape_form.hpp"
#include "math/tapes/internal/tape_range.hpp"
#include "math/tapes/lane_tape.hpp"

namespace kinestat {

/// A number of a recorder. The default one belongs to none.
struct TapeNumber {
  int node = -1;

  friend auto operator<=>(const TapeNumber&, const TapeNumber&) = default;
};

/// Every number also has a value, for one state by which decisions are taken. What follows from
/// constants alone is worked out at once, and so is what changes no bit of a finite number: times
/// or over one, plus zero. The same operation on the same numbers is noted once. What is demanded
/// of a number whose range leaves no doubt is not noted.
class LaneRecorder {
 public:
  TapeNumber constant(double value);

  /// The next input, which a lane may only give a number of that range.
  TapeNumber input(double value, const TapeRange& range = {});

  double value(TapeNumber a) const { return node(a).value; }

  const TapeRange& range(TapeNumber a) const { return node(a).range; }

  bool is_constant(TapeNumber a) const { return node(a).what == What::constant; }

  /// A constant zero.
  bool is_zero(TapeNumber a) const { return is_constant(a) && value(a) == 0.0; }

  TapeNumber add(TapeNumber a, TapeNumber b);
  TapeNumber subtract(TapeNumber a, TapeNumber b);
  TapeNumber multiply(TapeNumber a, TapeNumber b);
  TapeNumber divide(TapeNumber a, TapeNumber b);
  TapeNumber smaller(TapeNumber a, TapeNumber b);
  TapeNumber larger(TapeNumber a, TapeNumber b);

  /// a, or an exact zero where its magnitude is at most that bound.
  TapeNumber zero_within(TapeNumber a, TapeNumber bound);

  /// -(a · b)
  TapeNumber negate_product(TapeNumber a, TapeNumber b);

  /// a - b · c, or an exact zero where that is mere rounding of both.
  TapeNumber subtract_product(TapeNumber a, TapeNumber b, TapeNumber c);

  struct Product {
    TapeNumber a;
    TapeNumber b;
  };

  /// x of Σ a · b + pivot · x = 0, or an exact zero where the sum is mere rounding of its terms.
  TapeNumber substitute(std::span<const Product> products, TapeNumber pivot);

  /// A lane in which one of these does not hold has no answer; NaN never meets one.
  void demand_at_most(TapeNumber magnitude_of, TapeNumber limit);
  void demand_at_least(TapeNumber magnitude_of, TapeNumber limit);

  /// That a product b · c, or a quotient b / c, is zero only where b or c is.
  void demand_no_underflow(TapeNumber result, TapeNumber b, TapeNumber c);

  /// What the outputs and the demands need.
  LaneTape make_tape(std::span<const TapeNumber> outputs) const;

 private:
  friend class LaneTapeMaker;
  using Kind = LaneOperationKind;
  using Operands = std::array<int, 3>;  // nodes; -1 where there is none

  enum class What { constant, input, operation };

  struct Node {
    What what = What::constant;
    double value = 0.0;
    TapeRange range;
    std::optional<TapeForm> form = std::nullopt;  ///< where it is affine in inputs that have bounds
    int input = -1;
    Kind kind = Kind::add;
    Operands operands = {-1, -1, -1};
    int first_product = 0;  ///< of a substitution
    int end_product = 0;
  };

  const Node& node(TapeNumber a) const { return nodes_[static_cast<std::size_t>(a.node)]; }

  bool has_value(TapeNumber a, double value) const {
    return is_constant(a) && this->value(a) == value;
  }

  TapeNumber push(const Node& node);
  std::optional<TapeForm> form(TapeNumber a) const;
  TapeNumber operation(Kind kind, double value, const TapeRange& range, const Operands& operands);
  TapeNumber affine(Kind kind,
                    double value,
                    const TapeRange& range,
                    const Operands& operands,
                    std::optional<TapeForm> form);
  TapeNumber scaled(TapeNumber a, double factor);
  void demand(Kind kind, const Operands& operands);

  std::vector<Node> nodes_;
  std::vector<Product> products_;
  std::vector<int> demands_;  ///< nodes
  int input_count_ = 0;
  std::map<int, int> limits_;               ///< of a node: the demand that it is at most a constant
  std::map<std::uint64_t, int> constants_;  ///< by their bits
  std::map<std::pair<Kind, Operands>, int> operations_;  ///< but substitutions
};

}  // namespace kinestat
