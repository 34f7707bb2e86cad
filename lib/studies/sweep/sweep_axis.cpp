#include "studies/sweep/sweep_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "expression/whole_range.hpp"

namespace kinestat {

namespace {

constexpr double kLargestWhole = 9007199254740992.0;  // 2^53: up to here doubles are exact

BasicQuantity<Exact> evaluated(const Value& value, const BasicParameterTable<Exact>& exact) {
  const auto result = evaluate<Exact>(value.expression, exact.lookup());
  KINESTAT_EXPECTS(std::holds_alternative<BasicQuantity<Exact>>(result));
  return std::get<BasicQuantity<Exact>>(result);
}

double count_of(const Exact& value, const UnitScale& unit) {
  const std::optional<Rational> exact = exact_count(value, unit);
  return exact ? to_double(*exact) : unit.from_si(value.value);
}

}  // namespace

SweepAxis::SweepAxis(const MechanismDescription& description,
                     const VariedParameter& varied,
                     const BasicParameterTable<Exact>& exact)
    : name_(varied.name.text), parameter_(exact.index_of(varied.name.text)) {
  KINESTAT_EXPECTS(parameter_ >= 0);
  dimension_ =
      evaluated(varied.values.empty() ? *varied.from : varied.values.front(), exact).dimension;
  unit_ = description.units.unit_of(dimension_);
  above_ = UnitScale{unit_.scale.numerator, 1.0, unit_.scale.pi_power}.factor();
  below_ = unit_.scale.denominator;
  if (!varied.values.empty()) {
    read_list(varied.values, exact);
  } else if (varied.step) {
    read_range(varied, exact);
  } else {
    read_interval(varied, exact);
  }
}

void SweepAxis::read_list(const std::vector<Value>& values,
                          const BasicParameterTable<Exact>& exact) {
  for (const Value& value : values) {
    const Exact number = evaluated(value, exact).value;
    counts_.push_back(count_of(number, unit_.scale));
    values_.push_back(number.value);
  }
  size_ = values.size();
}

void SweepAxis::run_through(std::vector<double> counts) {
  is_interval_ = false;
  is_of_rows_ = true;
  size_ = counts.size();
  counts_ = std::move(counts);
  values_.clear();
  values_.reserve(counts_.size());
  for (const double count : counts_) {
    values_.push_back(count * above_ / below_);
  }
}

void SweepAxis::read_range(const VariedParameter& varied, const BasicParameterTable<Exact>& exact) {
  const Exact from = evaluated(*varied.from, exact).value;
  const Exact to = evaluated(*varied.to, exact).value;
  const Exact step = evaluated(*varied.step, exact).value;
  const auto whole = whole_range(
      exact_count(from, unit_.scale), exact_count(to, unit_.scale), exact_count(step, unit_.scale));
  if (whole) {
    from_ = whole->from;
    step_ = whole->step;
    denominator_ = whole->denominator;
    size_ = static_cast<std::uint64_t>(whole->last) + 1;
  } else {
    from_ = unit_.scale.from_si(from.value);
    step_ = unit_.scale.from_si(step.value);
    const double ways = (to.value - from.value) / step.value;
    size_ = static_cast<std::uint64_t>(std::floor(ways + kSameValue * std::max(1.0, ways))) + 1;
  }
  keep_values();
}

void SweepAxis::read_interval(const VariedParameter& varied,
                              const BasicParameterTable<Exact>& exact) {
  from_ = count_of(evaluated(*varied.from, exact).value, unit_.scale);
  to_ = count_of(evaluated(*varied.to, exact).value, unit_.scale);
  is_interval_ = true;
  size_ = static_cast<std::uint64_t>(kLargestWhole);
}

// Both shares are exact; rounding may lead out of the range.
double SweepAxis::count_within(std::uint64_t index) const {
  const double share = static_cast<double>(index) / kLargestWhole;
  const auto [least, most] = std::minmax(from_, to_);
  return std::clamp(from_ * (1.0 - share) + to_ * share, least, most);
}

// So that a state need not divide.
void SweepAxis::keep_values() {
  constexpr std::uint64_t kMostKept = 4096;
  std::vector<double> values;
  for (std::uint64_t i = 0; i < size_ && size_ <= kMostKept; ++i) {
    values.push_back(number_at(i));
  }
  values_ = std::move(values);
}

bool SweepAxis::is_whole(double count) const {
  constexpr double kMostCounted = 1e15;
  return unit_.text.empty() && count == std::floor(count) && std::abs(count) < kMostCounted;
}

// What two counts that follow each other on a range have for a difference, all have.
bool SweepAxis::has_whole_counts() const {
  if (is_interval_) {
    return false;
  }
  const auto is_whole_one = [this](double count) { return is_whole(count); };
  return counts_.empty() ? is_whole(count_at(0)) && is_whole(count_at(size_ - 1)) &&
                               (size_ == 1 || is_whole(step_ / denominator_))
                         : std::ranges::all_of(counts_, is_whole_one);
}

std::pair<double, double> SweepAxis::bounds() const {
  if (is_of_rows_) {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    return {-kAny, kAny};
  }
  if (is_interval_) {
    return std::minmax({from_ * above_ / below_, to_ * above_ / below_});
  }
  if (counts_.empty()) {
    // The values of a range keep their order when they are rounded.
    return std::minmax({value_at(0).value, value_at(size_ - 1).value});
  }
  const auto [least, most] = std::ranges::minmax_element(values_);
  return {*least, *most};
}

}  // namespace kinestat
