#include "math/tapes/internal/lane_player.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>

#include "core/tolerance.hpp"
#include "math/tapes/for_each_machine.hpp"
#include "math/tapes/lane_tape.hpp"

namespace kinestat {

namespace {

// Vectors of g++ and clang have the operators of numbers; a comparison gives all bits or none.
using Numbers = double __attribute__((vector_size(kLanes * sizeof(double)), may_alias));
using Flags = std::int64_t __attribute__((vector_size(kLanes * sizeof(double)), may_alias));

// What one lane and vectors do not spell alike. By reference, for how vectors are passed by value
// depends on the machine.
struct OneLane {
  using Number = double;
  using Flag = std::int64_t;

  [[gnu::always_inline]] static void set(bool from, Flag& to) { to = from ? -1 : 0; }

  [[gnu::always_inline]] static void set_magnitude(const Number& x, Number& result) {
    result = std::abs(x);
  }

  [[gnu::always_inline]] static void set_zero(bool where, Number& x) { x = where ? 0.0 : x; }
};

struct AllLanes {
  using Number = Numbers;
  using Flag = Flags;

  [[gnu::always_inline]] static void set(const Flag& from, Flag& to) { to = from; }

  [[gnu::always_inline]] static void set_magnitude(const Number& x, Number& result) {
    constexpr std::int64_t kAllButSign = 0x7fff'ffff'ffff'ffff;
    reinterpret_cast<Flags&>(result) = reinterpret_cast<const Flags&>(x) & kAllButSign;
  }

  [[gnu::always_inline]] static void set_zero(const Flag& where, Number& x) {
    reinterpret_cast<Flags&>(x) &= ~where;
  }
};

template <class Lanes>
class Player {
 public:
  using Number = typename Lanes::Number;
  using Flag = typename Lanes::Flag;

  [[gnu::always_inline]] Player(const LaneOperations& tape, double* cells)
      : products_(tape.products.data()), cells_(reinterpret_cast<Number*>(cells)) {}

  [[gnu::always_inline]] void play(const LaneOperation& one) {
    Number& target = cells_[one.target];
    using enum LaneOperationKind;
    switch (one.kind) {
      case add:
        target = cells_[one.a] + cells_[one.b];
        break;
      case subtract:
        target = cells_[one.a] - cells_[one.b];
        break;
      case multiply:
        target = cells_[one.a] * cells_[one.b];
        break;
      case divide:
        target = cells_[one.a] / cells_[one.b];
        break;
      case negate_product:
        target = -(cells_[one.a] * cells_[one.b]);
        break;
      case subtract_product:
        subtract_one(cells_[one.a], cells_[one.b], cells_[one.c], target);
        break;
      case substitute_sum:
        substitute(one, target);
        break;
      case zero_within:
        set_zero_within(cells_[one.a], cells_[one.b], target);
        break;
      case smaller:
        target = cells_[one.b] < cells_[one.a] ? cells_[one.b] : cells_[one.a];
        break;
      case larger:
        target = cells_[one.a] < cells_[one.b] ? cells_[one.b] : cells_[one.a];
        break;
      case demand_at_most:
        demand_order(cells_[one.a], cells_[one.b]);
        break;
      case demand_at_least:
        demand_size(cells_[one.a], cells_[one.b]);
        break;
      case demand_no_underflow:
        demand_value(cells_[one.a], cells_[one.b], cells_[one.c]);
        break;
    }
  }

  [[gnu::always_inline]] void copy_failures(std::int64_t* failures) const {
    std::memcpy(failures, &failures_, sizeof failures_);
  }

 private:
  // `x`, or an exact zero where it is mere rounding of terms of that size.
  [[gnu::always_inline]] static void set_without_rounding(const Number& x,
                                                          const Number& size,
                                                          Number& result) {
    set_zero_within(x, kCancellation * size, result);
  }

  [[gnu::always_inline]] static void set_zero_within(const Number& x,
                                                     const Number& bound,
                                                     Number& result) {
    Number magnitude;
    Lanes::set_magnitude(x, magnitude);
    Number kept = x;
    Lanes::set_zero(magnitude <= bound, kept);
    result = kept;
  }

  [[gnu::always_inline]] static void subtract_one(const Number& a,
                                                  const Number& b,
                                                  const Number& c,
                                                  Number& target) {
    const Number product = b * c;
    Number size_a;
    Number size_product;
    Lanes::set_magnitude(a, size_a);
    Lanes::set_magnitude(product, size_product);
    set_without_rounding(a - product, size_a + size_product, target);
  }

  [[gnu::always_inline]] void substitute(const LaneOperation& one, Number& target) const {
    Number sum{};
    Number size{};
    for (std::int32_t i = one.a; i < one.b; ++i) {
      const Number product = cells_[products_[i].a] * cells_[products_[i].b];
      Number magnitude;
      Lanes::set_magnitude(product, magnitude);
      sum -= product;
      size += magnitude;
    }
    const Number pivot = cells_[one.c];
    set_without_rounding(sum, size, sum);
    target = sum / pivot;
  }

  // |a| ≤ b
  [[gnu::always_inline]] void demand_order(const Number& a, const Number& b) {
    Number magnitude;
    Lanes::set_magnitude(a, magnitude);
    Flag is_met;
    Lanes::set(magnitude <= b, is_met);
    failures_ |= ~is_met;
  }

  // |a| ≥ b
  [[gnu::always_inline]] void demand_size(const Number& a, const Number& b) {
    Number magnitude;
    Lanes::set_magnitude(a, magnitude);
    Flag is_met;
    Lanes::set(magnitude >= b, is_met);
    failures_ |= ~is_met;
  }

  [[gnu::always_inline]] static void set_whether_zero(const Number& x, Flag& result) {
    Number magnitude;
    Lanes::set_magnitude(x, magnitude);
    Lanes::set(magnitude <= Number{}, result);
  }

  // a, or one of its factors, is zero for another reason than underflow.
  [[gnu::always_inline]] void demand_value(const Number& a, const Number& b, const Number& c) {
    Flag is_zero;
    Flag is_b_zero;
    Flag is_c_zero;
    set_whether_zero(a, is_zero);
    set_whether_zero(b, is_b_zero);
    set_whether_zero(c, is_c_zero);
    failures_ |= is_zero & ~(is_b_zero | is_c_zero);
  }

  const LaneProduct* products_;
  Number* cells_;
  Flag failures_{};
};

// clang gives its versions a name that only this file knows.
KINESTAT_FOR_EACH_MACHINE
void play_all(const LaneOperations& tape, double* cells, std::int64_t* failures) {
  Player<AllLanes> player(tape, cells);
  for (const LaneOperation& one : tape.operations) {
    player.play(one);
  }
  player.copy_failures(failures);
}

}  // namespace

void play_one(const LaneOperations& tape, double* cells, std::int64_t* failures) {
  Player<OneLane> player(tape, cells);
  for (const LaneOperation& one : tape.operations) {
    player.play(one);
  }
  player.copy_failures(failures);
}

void play_lanes(const LaneOperations& tape, double* cells, std::int64_t* failures) {
  play_all(tape, cells, failures);
}

}  // namespace kinestat
