#include "studies/benchmark/trade_off.hpp"

#include <algorithm>
#include <cmath>

namespace kinestat {

namespace {

bool is_finite(const MethodAnswer& answer) {
  return std::ranges::all_of(answer.x,
                             [](const DoubleDouble& one) { return std::isfinite(one.high); });
}

double error_of(const DoubleDouble& x, const Rational& exact) {
  return std::abs(to_double(exact - Rational(x.high) - Rational(x.low)));
}

// Where all unknowns are zero, errors are absolute.
ExtremeResult judge(const PreparedProblem& prepared, SolveMethod method) {
  const MethodAnswer answer = prepared.solve(method);
  ExtremeResult result;
  if (answer.x.empty() || !is_finite(answer)) {
    result.status = answer.x.empty() ? MethodStatus::refused : MethodStatus::not_finite;
    return result;
  }
  double largest = 0.0;
  double error = 0.0;
  double value_error = 0.0;
  for (std::size_t i = 0; i < answer.x.size(); ++i) {
    const Rational& exact = prepared.problem().exact[i];
    const double size = std::abs(to_double(exact));
    const double off = method == SolveMethod::exact ? 0.0 : error_of(answer.x[i], exact);
    largest = std::max(largest, size);
    error = std::max(error, off);
    if (size > 0.0) {
      value_error = std::max(value_error, off / size);
    }
  }
  const double scale = largest > 0.0 ? largest : 1.0;
  result.error = error / scale;
  result.value_error = value_error;
  if (answer.bound) {
    result.bound = answer.bound->maxCoeff() / scale;
  }
  return result;
}

void find_worst(MethodResult& method) {
  double worst = 0.0;
  for (const ExtremeResult& one : method.extremes) {
    if (!one.error) {
      return;
    }
    worst = std::max(worst, *one.error);
  }
  method.worst_error = worst;
}

// At least as fast and as accurate, and one of them more.
bool beats(const MethodResult& a, const MethodResult& b) {
  return a.worst_error && b.worst_error && a.time <= b.time && *a.worst_error <= *b.worst_error &&
         (a.time < b.time || *a.worst_error < *b.worst_error);
}

void find_front(std::vector<MethodResult>& methods) {
  for (MethodResult& one : methods) {
    one.is_on_front =
        one.worst_error &&
        std::ranges::none_of(methods, [&](const MethodResult& other) { return beats(other, one); });
  }
}

void time_methods(const PreparedProblem& prepared,
                  const TimingLimits& limits,
                  const Clock& clock,
                  TradeOff& result) {
  std::vector<std::function<void()>> jobs;
  for (const SolveMethod method : kSolveMethods) {
    jobs.emplace_back([&prepared, method] { prepared.run(method); });
  }
  const InterleavedTimes times =
      time_interleaved([&] { prepared.run(SolveMethod::double_lu); }, jobs, limits, clock);
  for (std::size_t m = 0; m < result.methods.size(); ++m) {
    const std::vector<double>& ratios = times.ratios[m];
    result.methods[m].time = median_of(ratios);
    result.methods[m].fastest = *std::ranges::min_element(ratios);
    result.methods[m].slowest = *std::ranges::max_element(ratios);
  }
  result.unit_seconds = median_of(times.unit);
}

}  // namespace

std::string_view text_of(MethodStatus status) {
  switch (status) {
    case MethodStatus::solved:
      return "solved";
    case MethodStatus::refused:
      return "refused";
    case MethodStatus::not_finite:
      break;
  }
  return "not finite";
}

TradeOff find_trade_off(const Mechanism& mechanism,
                        const Case& which,
                        ProblemSide side,
                        const TimingLimits& limits,
                        const Clock& clock) {
  TradeOff result;
  std::vector<PreparedProblem> problems;
  for (const Extreme& extreme : kExtremes) {
    ProblemAnswer answer = make_problem(mechanism, which, side, extreme);
    if (!answer.problem) {
      result.reason = answer.reason;
      return result;
    }
    problems.push_back(PreparedProblem(*std::move(answer.problem)));
  }
  result.unknowns = static_cast<int>(problems.front().problem().secondary.size());
  for (const SolveMethod method : kSolveMethods) {
    MethodResult one{.method = method, .extremes = {}, .worst_error = {}};
    for (const PreparedProblem& problem : problems) {
      one.extremes.push_back(judge(problem, method));
    }
    find_worst(one);
    result.methods.push_back(std::move(one));
  }
  time_methods(problems.front(), limits, clock, result);
  find_front(result.methods);
  return result;
}

}  // namespace kinestat
