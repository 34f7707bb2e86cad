// What accuracy costs: methods against extremes, in time and in error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/benchmark/extreme.hpp"
#include "studies/benchmark/interleaved_times.hpp"
#include "studies/benchmark/solve_method.hpp"

namespace kinestat {

/// What a method makes of one extreme.
enum class MethodStatus {
  solved,
  refused,    ///< it takes the equations for singular, and says so
  not_finite  ///< an overflow or a division by zero
};

/// "solved", "refused", "not finite"
std::string_view text_of(MethodStatus status);

/// Errors are those against the exact solution of the same doubles.
struct ExtremeResult {
  MethodStatus status = MethodStatus::solved;
  std::optional<double> error;        ///< largest, as a share of the largest unknown of its kind
  std::optional<double> value_error;  ///< largest as a share of the unknown itself
  std::optional<double> bound;        ///< what the method says of `error`; empty: nothing
};

struct MethodResult {
  SolveMethod method = SolveMethod::double_lu;
  double time = 0.0;  ///< as drawn, in units of double_lu: median of the rounds
  double fastest = 0.0;
  double slowest = 0.0;
  std::vector<ExtremeResult> extremes;  ///< in the order of kExtremes
  std::optional<double> worst_error;    ///< of all extremes; empty if one has no answer
  bool is_on_front = false;             ///< no other method is both faster and more accurate
};

/// One side of a case.
struct TradeOff {
  NoProblem reason = NoProblem::none;  ///< why there are no results
  int unknowns = 0;
  double unit_seconds = 0.0;  ///< of double_lu: median
  std::vector<MethodResult> methods;
};

/// Solves each extreme by all methods, and times them as drawn.
TradeOff find_trade_off(const Mechanism& mechanism,
                        const Case& which,
                        ProblemSide side,
                        const TimingLimits& limits,
                        const Clock& clock);

}  // namespace kinestat
