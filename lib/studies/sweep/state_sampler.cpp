#include "studies/sweep/state_sampler.hpp"

#include <cmath>
#include <variant>

#include "core/contract.hpp"

namespace kinestat {

namespace {

__extension__ using Wide = unsigned __int128;

// That share of 2^64 of so many.
std::uint64_t share_of(std::uint64_t count, std::uint64_t share) {
  return static_cast<std::uint64_t>(static_cast<Wide>(count) * share >> 64U);
}

std::uint64_t whole(const Value& value, const ParameterTable& table) {
  const auto result = evaluate(value.expression, table.lookup());
  KINESTAT_EXPECTS(std::holds_alternative<Quantity>(result));
  return static_cast<std::uint64_t>(std::llround(std::get<Quantity>(result).value));
}

}  // namespace

SampleChoice sample_choice(const MechanismDescription& description) {
  const SampleDescription& sample = *description.sweep->sample;
  const ParameterTable table = evaluate_parameters(parameters_of(description)).table;
  return {.count = whole(*sample.count, table),
          .method = sample.method,
          .seed = sample.seed ? whole(*sample.seed, table) : kUsualSeed};
}

StateSampler::StateSampler(const SampleChoice& choice, std::size_t axes)
    : choice_(choice), bits_(choice.seed) {
  if (choice.method == SampleMethod::sobol) {
    sobol_.emplace(axes, choice.count);
  }
  for (std::size_t i = 0; i < axes; ++i) {
    shifts_.push_back(bits_.at(axes + i, 0));
    if (choice.method == SampleMethod::latin) {
      orders_.emplace_back(choice.count, bits_, 2 * axes + i);
    }
  }
}

std::uint64_t StateSampler::place_of(std::uint64_t state,
                                     std::size_t axis,
                                     const SweepAxis& values) const {
  if (choice_.method == SampleMethod::latin) {
    return latin_place(state, axis, values);
  }
  return share_of(values.size(),
                  sobol_ ? sobol_->at(state, axis) ^ shifts_[axis] : bits_.at(axis, state));
}

// Part p of n reaches from p/n to (p + 1)/n of the axis. Somewhere in it, where it holds many
// places; of a list each part has the place under the same share of it, so that each place falls to
// as many parts, but for one.
std::uint64_t StateSampler::latin_place(std::uint64_t state,
                                        std::size_t axis,
                                        const SweepAxis& values) const {
  const std::uint64_t part = orders_[axis].at(state);
  const auto first_from = [&](std::uint64_t share, std::uint64_t up) {
    return static_cast<std::uint64_t>((static_cast<Wide>(share) * values.size() + up) /
                                      choice_.count);
  };
  if (!values.is_interval()) {
    return first_from(part, share_of(values.size(), shifts_[axis]));
  }
  const std::uint64_t least = first_from(part, choice_.count - 1);
  const std::uint64_t end = first_from(part + 1, choice_.count - 1);
  return least + share_of(end - least, bits_.at(axis, state));
}

}  // namespace kinestat
