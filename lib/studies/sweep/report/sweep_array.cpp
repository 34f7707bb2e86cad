#include "studies/sweep/report/sweep_array.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

#include "report/npy.hpp"
#include "studies/sweep/report/sweep_status.hpp"

namespace kinestat {

namespace {

std::uint64_t bytes_of_place(std::size_t place) {
  return npy_bytes_of_whole(static_cast<std::int64_t>(place));
}

}  // namespace

std::string sweep_dtype(const SweepPlan& plan, std::span<const SweepColumn> columns) {
  std::vector<NpyField> fields;
  for (const std::string& title : sweep_titles(plan, columns)) {
    fields.push_back({.name = title});
  }
  for (std::size_t i = 0; i < plan.axes().size(); ++i) {
    fields[i].is_whole = plan.axes()[i].has_whole_counts();
  }
  fields[plan.axes().size()].is_whole = true;
  fields.back().is_whole = true;
  return npy_dtype(fields);
}

SweepRowArray::SweepRowArray(const SweepPlan& plan, std::span<const SweepColumn> columns)
    : plan_(plan),
      places_(plan.axes().size(), std::numeric_limits<std::uint64_t>::max()),
      fields_(plan.axes().size() + columns.size() + 2) {
  for (const SweepAxis& axis : plan.axes()) {
    is_whole_.push_back(axis.has_whole_counts() ? 1 : 0);
  }
  // Which makes the list of all statuses, so that no row does.
  fields_.back() = bytes_of_place(status_number(SweepRow{}.status));
}

void SweepRowArray::enter(std::span<const std::uint64_t> places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] != places_[i]) {
      const double count = plan_.axes()[i].count_at(places[i]);
      fields_[i] = is_whole_[i] != 0 ? npy_bytes_of_whole(static_cast<std::int64_t>(count))
                                     : npy_bytes(count);
      places_[i] = places[i];
    }
  }
}

void SweepRowArray::append(const SweepRow& row, std::string& rows) {
  std::uint64_t* field = fields_.data() + places_.size();
  *field++ = bytes_of_place(row.which);
  field = std::ranges::transform(row.values, field, [](double one) { return npy_bytes(one); }).out;
  *field = bytes_of_place(status_number(row.status));
  rows.append(reinterpret_cast<const char*>(fields_.data()), 8 * fields_.size());
}

}  // namespace kinestat
