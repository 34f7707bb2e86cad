#include "studies/transmissions/corner_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/synthesis_tolerance.hpp"
#include "math/tapes/for_each_machine.hpp"

namespace kinestat {

namespace {

// Vectors of g++ and clang have the operators of numbers.
using Lanes = double __attribute__((vector_size(kRatioLanes * sizeof(double)), may_alias));

constexpr std::size_t kMostProducts = 81;  // 3^kMostGearSets

using LaneEquations = std::array<SetEquation<RatioLanes>, kMostGearSets>;

KINESTAT_FOR_EACH_MACHINE
void evaluate_minors(const RatioLanes* coefficients,
                     std::size_t sets,
                     const SetMinors::Product* first,
                     const SetMinors::Product* last,
                     RatioLanes* minors,
                     std::size_t count) {
  alignas(64) Lanes products[kMostProducts];
  const auto* given = reinterpret_cast<const Lanes*>(coefficients);
  auto* sums = reinterpret_cast<Lanes*>(minors);
  products[0] = Lanes{} + 1.0;
  std::size_t made = 1;
  for (std::size_t s = 0; s < sets; ++s) {
    for (std::size_t i = made; i-- > 0;) {
      const Lanes left = products[i];
      for (std::size_t t = 0; t < 3; ++t) {
        products[3 * i + t] = left * given[3 * s + t];
      }
    }
    made *= 3;
  }
  for (std::size_t i = 0; i < count; ++i) {
    sums[i] = Lanes{};
  }
  for (const SetMinors::Product* one = first; one != last; ++one) {
    if (one->is_negative) {
      sums[one->minor] -= products[one->product];
    } else {
      sums[one->minor] += products[one->product];
    }
  }
}

KINESTAT_FOR_EACH_MACHINE
void add_terms(const MinorTerm* first,
               const MinorTerm* last,
               const RatioLanes* minors,
               RatioLanes* sum) {
  const auto* given = reinterpret_cast<const Lanes*>(minors);
  Lanes result{};
  for (const MinorTerm* term = first; term != last; ++term) {
    if (term->is_negative) {
      result -= given[term->minor];
    } else {
      result += given[term->minor];
    }
  }
  *reinterpret_cast<Lanes*>(sum) = result;
}

KINESTAT_FOR_EACH_MACHINE
void widen(const RatioLanes* input, const RatioLanes* output, double* least_and_largest) {
  const Lanes ratio =
      *reinterpret_cast<const Lanes*>(input) / *reinterpret_cast<const Lanes*>(output);
  for (std::size_t i = 0; i < kRatioLanes; ++i) {
    least_and_largest[0] = ratio[i] < least_and_largest[0] ? ratio[i] : least_and_largest[0];
    least_and_largest[1] = ratio[i] > least_and_largest[1] ? ratio[i] : least_and_largest[1];
  }
}

// Whether all are above zero, or all below, and of which sign.
int common_sign(const RatioLanes& lanes) {
  const auto [least, largest] = std::ranges::minmax(lanes.at);
  return least > 0.0 ? 1 : largest < 0.0 ? -1 : 0;
}

}  // namespace

SetEquation<double> set_equation(const RoleChoice& choice, int set, double stationary_ratio) {
  const SetRoles roles = set_roles(choice.roles_of(set));
  const double i0 = choice.kind_of(set) == SetKind::simple ? -stationary_ratio : stationary_ratio;
  SetEquation<double> equation{};
  equation[roles.sun] = 1.0;
  equation[roles.ring] = -i0;
  equation[roles.carrier] = i0 - 1.0;
  return equation;
}

RatioTable::RatioTable(const GenericTrain& train)
    : train_(train), minors_(2 * train.minors().count()) {}

void RatioTable::set_points(const RoleChoice& choice, std::span<const StationaryPoint> points) {
  blocks_ = points.size() / kRatioLanes;
  const auto sets = static_cast<std::size_t>(train_.structure().set_count());
  const std::size_t count = train_.minors().count();
  for (std::size_t block = 0; block < blocks_; ++block) {
    LaneEquations lanes;
    for (std::size_t s = 0; s < sets; ++s) {
      for (std::size_t lane = 0; lane < kRatioLanes; ++lane) {
        const SetEquation<double> equation =
            set_equation(choice, static_cast<int>(s), points[block * kRatioLanes + lane][s]);
        for (std::size_t t = 0; t < 3; ++t) {
          lanes[s][t].at[lane] = equation[t];
        }
      }
    }
    const auto products = train_.minors().products();
    evaluate_minors(lanes.front().data(),
                    sets,
                    products.data(),
                    products.data() + products.size(),
                    minors_.data() + block * count,
                    count);
  }
}

void RatioTable::set_corners(const RoleChoice& choice, const StationaryBox& box) {
  std::array<StationaryPoint, 2 * kRatioLanes> corners{};
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    for (std::size_t s = 0; s < kMostGearSets; ++s) {
      corners[corner][s] = (corner >> s & 1U) != 0 ? box.to[s] : box.from[s];
    }
  }
  const bool has_one_block = train_.structure().set_count() < kMostGearSets;
  set_points(choice, std::span(corners).first(has_one_block ? kRatioLanes : 2 * kRatioLanes));
}

void RatioTable::ranges(std::span<const std::uint32_t> states,
                        std::span<ClosedRange> ranges) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::size_t count = train_.minors().count();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (train_.states()[states[i]].is_direct) {
      ranges[i] = {.from = 1.0, .to = 1.0};
      continue;
    }
    const auto input = train_.input_terms(states[i]);
    const auto output = train_.output_terms(states[i]);
    double range[2] = {kInfinity, -kInfinity};
    int sign = 0;
    for (std::size_t block = 0; block < blocks_; ++block) {
      const RatioLanes* minors = minors_.data() + block * count;
      RatioLanes inputs;
      RatioLanes outputs;
      add_terms(output.data(), output.data() + output.size(), minors, &outputs);
      const int its = common_sign(outputs);
      if (its == 0 || its == -sign) {
        range[0] = -kInfinity;
        range[1] = kInfinity;
        break;
      }
      sign = its;
      add_terms(input.data(), input.data() + input.size(), minors, &inputs);
      widen(&inputs, &outputs, range);
    }
    ranges[i] = {.from = range[0], .to = range[1]};
  }
}

void RatioTable::find_speeds(std::uint32_t state, std::size_t block, SpeedLanes& speeds) const {
  const RatioLanes* minors = minors_.data() + block * train_.minors().count();
  const auto input = train_.input_terms(state);
  const auto output = train_.output_terms(state);
  add_terms(input.data(), input.data() + input.size(), minors, &speeds.input);
  add_terms(output.data(), output.data() + output.size(), minors, &speeds.output);
}

void RatioTable::speeds(std::span<const std::uint32_t> states, std::span<SpeedLanes> speeds) const {
  for (std::size_t i = 0; i < states.size(); ++i) {
    find_speeds(states[i], 0, speeds[i]);
  }
}

void RatioTable::ratios(std::span<const std::uint32_t> states, std::span<RatioLanes> ratios) const {
  for (std::size_t i = 0; i < states.size() * blocks_; ++i) {
    SpeedLanes speeds;
    find_speeds(states[i / blocks_], i % blocks_, speeds);
    for (std::size_t lane = 0; lane < kRatioLanes; ++lane) {
      const double input = speeds.input.at[lane];
      const double output = speeds.output.at[lane];
      ratios[i].at[lane] =
          std::abs(output) <= kRestingOutput * std::abs(input) ? 0.0 : input / output;
    }
  }
}

}  // namespace kinestat
