// One parameter of a sweep and the values that it runs through.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/exact.hpp"
#include "expression/file_units.hpp"

namespace kinestat {

/// The values of a long range are made when they are asked for, so that an axis of a million takes
/// no memory. A range counts exactly where its ends and its step are fractions in the unit of the
/// file: 0.1 to 0.3 by 0.1 has three values, and the third is the double that is typed 0.3. A range
/// without a step has as many values as there are shares of 2^-53, the first of them `from`.
class SweepAxis {
 public:
  /// `description` must have passed bind, `varied` belong to its sweep and `exact` hold its
  /// parameters.
  SweepAxis(const MechanismDescription& description,
            const VariedParameter& varied,
            const BasicParameterTable<Exact>& exact);

  /// From now on it runs through these values, counted in its unit: those of rows.
  void run_through(std::vector<double> counts);

  const std::string& name() const { return name_; }

  /// Index of the parameter in the description.
  int parameter() const { return parameter_; }

  /// Of its values as they are shown; empty for a bare number.
  const std::string& unit() const { return unit_.text; }

  const Dimension& dimension() const { return dimension_; }

  std::uint64_t size() const { return size_; }

  /// Whether it is a range without a step.
  bool is_interval() const { return is_interval_; }

  /// Whether it runs through rows, which others may follow.
  bool is_of_rows() const { return is_of_rows_; }

  /// The value of that index, counted in the unit.
  double count_at(std::uint64_t index) const {
    return is_interval_      ? count_within(index)
           : counts_.empty() ? (from_ + static_cast<double>(index) * step_) / denominator_
                             : counts_[static_cast<std::size_t>(index)];
  }

  /// Whether this count is a bare whole number, such as teeth, which is written as one.
  bool is_whole(double count) const;

  /// Whether all counts are.
  bool has_whole_counts() const;

  /// In SI: what the file would give if the value were typed there.
  Quantity value_at(std::uint64_t index) const { return {number_at(index), dimension_}; }

  /// The number of value_at.
  double number_at(std::uint64_t index) const {
    return values_.empty() ? count_at(index) * above_ / below_
                           : values_[static_cast<std::size_t>(index)];
  }

  /// The smallest and the largest value [SI]. Of rows any, for others may follow them.
  std::pair<double, double> bounds() const;

 private:
  void read_list(const std::vector<Value>& values, const BasicParameterTable<Exact>& exact);
  void read_range(const VariedParameter& varied, const BasicParameterTable<Exact>& exact);
  void read_interval(const VariedParameter& varied, const BasicParameterTable<Exact>& exact);

  void keep_values();
  double count_within(std::uint64_t index) const;

  std::string name_;
  int parameter_ = -1;
  NamedUnit unit_;
  double above_ = 1.0;  ///< the unit in SI is above / below, as UnitScale::to_si has it
  double below_ = 1.0;
  Dimension dimension_;
  std::uint64_t size_ = 0;
  std::vector<double> counts_;  ///< of a list
  std::vector<double> values_;  ///< of a list or a short range, SI
  double from_ = 0.0;           ///< of a range: value i is (from + i · step) / denominator
  double step_ = 0.0;
  double denominator_ = 1.0;
  double to_ = 0.0;  ///< of a range without a step
  bool is_interval_ = false;
  bool is_of_rows_ = false;
};

}  // namespace kinestat
