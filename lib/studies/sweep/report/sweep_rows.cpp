#include "studies/sweep/report/sweep_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/exact_text.hpp"
#include "report/csv.hpp"
#include "report/json_values.hpp"

namespace kinestat {

namespace {

std::string title_of(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string csv_cell(const std::string& text) {
  std::string cell;
  append_csv_cell(text, cell);
  return cell;
}

}  // namespace

std::vector<std::string> sweep_titles(const SweepPlan& plan, std::span<const SweepColumn> columns) {
  std::vector<std::string> titles;
  for (const SweepAxis& axis : plan.axes()) {
    titles.push_back(title_of(axis.name(), axis.unit()));
  }
  titles.emplace_back("case");
  for (const SweepColumn& column : columns) {
    titles.push_back(title_of(column.name, column.unit));
  }
  titles.emplace_back("status");
  return titles;
}

std::vector<std::string> json_row_keys(std::span<const std::string> titles) {
  std::vector<std::string> keys;
  for (const std::string& title : titles) {
    keys.push_back(fmt::format("{}{}:", keys.empty() ? "{" : ",", Json(title).dump()));
  }
  return keys;
}

SweepRowText::SweepRowText(const SweepPlan& plan,
                           std::span<const Case> cases,
                           std::span<const SweepColumn> columns,
                           RowFormat format)
    : plan_(plan), format_(format), keys_(json_row_keys(sweep_titles(plan, columns))) {
  for (const Case& which : cases) {
    cases_.push_back(format == RowFormat::csv ? csv_cell(which.label) : Json(which.label).dump());
  }
  Cell zero;
  zero.length =
      static_cast<std::size_t>(write_exact(zero.value, zero.text.data()) - zero.text.data());
  cells_.assign(cases.size() * columns.size(), zero);
  std::size_t room = columns.size() * (kLongestExact + 1) + kRoomForExact;
  for (const std::string& key : keys_) {
    room += key.size();
  }
  numbers_.resize(room);
}

// From the first axis that has moved: the text of the others stands there already.
void SweepRowText::enter(std::span<const std::uint64_t> places) {
  const auto moved = std::ranges::mismatch(places, places_).in1 - places.begin();
  const auto kept = static_cast<std::size_t>(moved);
  ends_.resize(kept);
  beginning_.resize(kept == 0 ? 0 : ends_.back());
  for (std::size_t i = kept; i < places.size(); ++i) {
    append_parameter(i, places[i]);
    ends_.push_back(beginning_.size());
  }
  if (format_ == RowFormat::json) {
    beginning_ += keys_[places.size()];
  }
  places_.assign(places.begin(), places.end());
}

void SweepRowText::append_parameter(std::size_t axis, std::uint64_t place) {
  if (format_ == RowFormat::json) {
    beginning_ += keys_[axis];
  }
  const SweepAxis& one = plan_.axes()[axis];
  const double count = one.count_at(place);
  if (one.is_whole(count)) {
    const fmt::format_int digits(static_cast<long long>(count));
    beginning_.append(digits.data(), digits.size());
  } else {
    append_exact(count, beginning_);
  }
  if (format_ == RowFormat::csv) {
    beginning_ += ',';
  }
}

// The values of CSV.
char* SweepRowText::append_values(const SweepRow& row, char* end) {
  Cell* cell = cells_.data() + row.which * row.values.size();
  for (const double value : row.values) {
    *end++ = ',';
    if (!std::isnan(value)) {
      cell->take(value);
      end = cell->append_to(end);
    }
    ++cell;
  }
  return end;
}

// The values of JSON, each with its key.
char* SweepRowText::append_members(const SweepRow& row, char* end) {
  std::size_t column = plan_.axes().size() + 1;
  Cell* cell = cells_.data() + row.which * row.values.size();
  for (const double value : row.values) {
    end = std::ranges::copy(keys_[column++], end).out;
    if (std::isnan(value)) {
      end = std::ranges::copy(std::string_view("null"), end).out;
    } else {
      cell->take(value);
      end = cell->append_to(end);
    }
    ++cell;
  }
  return end;
}

void SweepRowText::append(const SweepRow& row, std::string& text) {
  const bool is_json = format_ == RowFormat::json;
  const char* begin = numbers_.data();
  const char* end =
      is_json ? append_members(row, numbers_.data()) : append_values(row, numbers_.data());
  text += beginning_;
  text += cases_[row.which];
  text.append(begin, end);
  text += is_json ? std::string_view(keys_.back()) : std::string_view(",");
  if (is_json) {
    text += '"';
  }
  text += row.status;
  text += is_json ? "\"}\n" : "\n";
}

void SweepRowText::Cell::take(double next) {
  if (next != value) {
    value = next;
    length = static_cast<std::size_t>(write_exact(next, text.data()) - text.data());
  }
}

// More than the text, which a processor copies faster than so many characters of it.
char* SweepRowText::Cell::append_to(char* end) const {
  std::memcpy(end, text.data(), kLongestExact);
  return end + length;
}

}  // namespace kinestat
