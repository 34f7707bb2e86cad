// The rows of a sweep in any of their formats.
#pragma once

#include <variant>

#include "studies/sweep/report/sweep_array.hpp"
#include "studies/sweep/report/sweep_rows.hpp"

namespace kinestat {

class SweepRowWriter {
 public:
  SweepRowWriter(const SweepPlan& plan,
                 std::span<const Case> cases,
                 std::span<const SweepColumn> columns,
                 RowFormat format)
      : form_(std::in_place_type<SweepRowArray>, plan, columns) {
    if (format != RowFormat::npy) {
      form_.emplace<SweepRowText>(plan, cases, columns, format);
    }
  }

  /// Takes the places of a state on the axes, which its rows then begin with.
  void enter(std::span<const std::uint64_t> places) {
    std::visit([&](auto& form) { form.enter(places); }, form_);
  }

  /// Appends the row of a case of that state.
  void append(const SweepRow& row, std::string& rows) {
    std::visit([&](auto& form) { form.append(row, rows); }, form_);
  }

 private:
  std::variant<SweepRowArray, SweepRowText> form_;
};

}  // namespace kinestat
