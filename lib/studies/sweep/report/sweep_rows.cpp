#include "studies/sweep/report/sweep_rows.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "report/csv.hpp"
#include "report/json_values.hpp"

namespace kinestat {

namespace {

std::string title_of(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string csv_cell(const std::string& text) {
  const std::string cells[] = {text};
  const std::string line = csv_line(cells);
  return line.substr(0, line.size() - 1);
}

// The shortest text that reads back as the same number, whole ones with ".0".
void append_number(double value, std::string& text) {
  if (value == 0.0) {
    text += "0.0";
    return;
  }
  const std::size_t before = text.size();
  fmt::format_to(std::back_inserter(text), "{}", value);
  if (text.find_first_of(".e", before) == std::string::npos) {
    text += ".0";
  }
}

void append_parameter(double count, bool is_bare_number, std::string& text) {
  constexpr double kMostDigits = 1e15;
  if (is_bare_number && count == std::floor(count) && std::abs(count) < kMostDigits) {
    fmt::format_to(std::back_inserter(text), "{}", static_cast<long long>(count));
  } else {
    append_number(count, text);
  }
}

}  // namespace

SweepRowText::SweepRowText(const SweepPlan& plan,
                           std::span<const Case> cases,
                           std::span<const SweepColumn> columns,
                           RowFormat format)
    : plan_(plan), format_(format) {
  for (const SweepAxis& axis : plan.axes()) {
    titles_.push_back(title_of(axis.name(), axis.unit()));
  }
  titles_.emplace_back("case");
  for (const SweepColumn& column : columns) {
    titles_.push_back(title_of(column.name, column.unit));
  }
  titles_.emplace_back("status");
  for (const std::string& title : titles_) {
    keys_.push_back(fmt::format("{}{}:", keys_.empty() ? "{" : ",", Json(title).dump()));
  }
  for (const Case& which : cases) {
    cases_.push_back(format == RowFormat::csv ? csv_cell(which.label) : Json(which.label).dump());
  }
  header_ = format == RowFormat::csv ? csv_line(titles_) : std::string();
}

std::string SweepRowText::signature() const {
  return format_ == RowFormat::csv ? header_ : keys_.front();
}

void SweepRowText::enter(std::span<const std::uint64_t> places) {
  beginning_.clear();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SweepAxis& axis = plan_.axes()[i];
    if (format_ == RowFormat::json) {
      beginning_ += keys_[i];
    }
    append_parameter(axis.count_at(places[i]), axis.unit().empty(), beginning_);
    if (format_ == RowFormat::csv) {
      beginning_ += ',';
    }
  }
  if (format_ == RowFormat::json) {
    beginning_ += keys_[places.size()];
  }
}

void SweepRowText::append(const SweepRow& row, std::string& text) const {
  const bool is_json = format_ == RowFormat::json;
  text += beginning_;
  text += cases_[row.which];
  std::size_t column = plan_.axes().size() + 1;
  for (const double value : row.values) {
    text += is_json ? std::string_view(keys_[column++]) : std::string_view(",");
    if (!std::isnan(value)) {
      append_number(value, text);
    } else if (is_json) {
      text += "null";
    }
  }
  if (is_json) {
    fmt::format_to(std::back_inserter(text), "{}\"{}\"}}\n", keys_[column], row.status);
  } else {
    text += ',';
    text += row.status;
    text += '\n';
  }
}

}  // namespace kinestat
