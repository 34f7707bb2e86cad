// Which values the states of a sample have.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "description/mechanism_description.hpp"
#include "math/sampling/counter_based_random.hpp"
#include "math/sampling/permutation.hpp"
#include "math/sampling/sobol_sequence.hpp"
#include "studies/sweep/sweep_axis.hpp"

namespace kinestat {

/// What is drawn, in numbers.
struct SampleChoice {
  std::uint64_t count = 1;
  SampleMethod method = SampleMethod::sobol;
  std::uint64_t seed = kUsualSeed;
};

/// Of a description that has passed bind and has a sample.
SampleChoice sample_choice(const MechanismDescription& description);

/// Draws a place on every axis for each state, without those before it and by integer arithmetic
/// alone: states, threads and machines change nothing.
///   sobol   a dimension of the sequence for each axis, shifted digit by digit by random bits,
///   which
///           moves the points and keeps how evenly they lie (Cranley and Patterson 1976, Owen 1995)
///   random  random bits of each state and axis
///   latin   of as many equal parts of the axis as there are states, each once, in an order of its
///           own for each axis (McKay, Beckman and Conover 1979)
class StateSampler {
 public:
  StateSampler(const SampleChoice& choice, std::size_t axes);

  const SampleChoice& choice() const { return choice_; }

  /// Below the size of that axis.
  std::uint64_t place_of(std::uint64_t state, std::size_t axis, const SweepAxis& values) const;

 private:
  std::uint64_t latin_place(std::uint64_t state, std::size_t axis, const SweepAxis& values) const;

  SampleChoice choice_;
  CounterBasedRandom bits_;
  std::optional<SobolSequence> sobol_;
  std::vector<std::uint64_t> shifts_;  ///< of each axis
  std::vector<Permutation> orders_;    ///< likewise, of its parts
};

}  // namespace kinestat
