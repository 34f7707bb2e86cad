// What formulas about the rows of a sweep may name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/slots.hpp"
#include "studies/sweep/report/sweep_column.hpp"
#include "studies/sweep/report/sweep_rows.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace kinestat {

/// Parameters and quantities of the rows by their names.
class RowNames {
 public:
  RowNames(const MechanismDescription& description, std::span<const SweepColumn> columns);

  /// Its slot: those of the parameters, then those of the quantities; -1 if there is none.
  int slot_of(const std::string& name) const;

  /// Likewise, of a quantity alone.
  int quantity_slot(const std::string& name) const;

  std::span<const std::string> names() const { return names_; }

 private:
  std::vector<std::string> names_;
  std::ptrdiff_t first_ = 0;  ///< place of the first quantity
};

/// The values of these names, row by row.
class RowScope {
 public:
  /// The plan must outlive it.
  RowScope(const SweepPlan& plan, std::span<const SweepColumn> columns);

  /// Takes the places of a state on the axes.
  void enter(std::span<const std::uint64_t> places);

  /// Takes a row of that state; a quantity that is a NaN has no value.
  void show(const SweepRow& row);

  const Slots& slots() const { return slots_; }

 private:
  const SweepPlan& plan_;
  std::vector<double> units_;  ///< of each quantity: SI per unit
  std::size_t first_ = 0;      ///< slot of the first quantity
  Slots slots_;
  std::vector<Quantity> scratch_;
};

}  // namespace kinestat
