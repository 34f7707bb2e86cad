#include "report/table_archive.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "expression/unit_quotient.hpp"
#include "report/csv.hpp"
#include "report/number_format.hpp"
#include "report/tables/component_name.hpp"

namespace kinestat {

TableArchive::TableArchive(std::string mechanism,
                           const FileUnits& units,
                           MissingNumber missing,
                           std::string_view parameters)
    : mechanism_(std::move(mechanism)), units_(units), missing_(missing), parameters_(parameters) {}

namespace {

constexpr std::string_view kParameterColumn = ",parameter";

// What all numbers of a value measure; empty where they are bare, or of several kinds.
std::optional<QuantityKind> kind_of(const Shape& shape) {
  if (shape.items.empty()) {
    const auto* kind = std::get_if<QuantityKind>(&shape.measure);
    return kind != nullptr ? std::optional(*kind) : std::nullopt;
  }
  const auto first = kind_of(shape.items.front());
  const bool are_alike =
      std::ranges::all_of(shape.items, [&](const Shape& item) { return kind_of(item) == first; });
  return are_alike ? first : std::nullopt;
}

}  // namespace

bool TableArchive::begin(const Property& property) {
  if (!property.is_in_tables) {
    return false;
  }
  properties_.push_back(&property);
  if (has_parameters(property)) {
    names_parameters_ = true;
    return true;
  }
  begin_tables(property);
  switch (property.table_role) {
    case TableRole::quantity:
    case TableRole::word:
      path_.push_back(property.table_quantity);
      break;
    case TableRole::element:
      element_keys_.push_back(!element_.empty());
      if (element_keys_.back()) {
        path_.push_back(property.table_quantity);
      } else {
        element_ = property.key;
        names_elements_ = true;
      }
      break;
    case TableRole::cases:
      names_cases_ = true;
      break;
    case TableRole::table:
    case TableRole::table_of_cases:
      names_cases_ = property.table_role == TableRole::table_of_cases;
      pass_ = property.key;
      status_ = "solved";
      break;
    case TableRole::status:
      reads_status_ = true;
      break;
  }
  return true;
}

void TableArchive::end(const Property& property) {
  properties_.pop_back();
  if (has_parameters(property)) {
    names_parameters_ = false;
    parameter_.clear();
    return;
  }
  switch (property.table_role) {
    case TableRole::quantity:
    case TableRole::word:
      path_.pop_back();
      break;
    case TableRole::element:
      if (element_keys_.back()) {
        path_.pop_back();
      } else {
        element_.clear();
      }
      element_keys_.pop_back();
      break;
    case TableRole::table:
    case TableRole::table_of_cases:
      pass_.clear();
      break;
    case TableRole::cases:
    case TableRole::status:
      break;
  }
}

void TableArchive::element(std::string_view name, std::string_view status) {
  if (!open_.empty() && open_.back().kind == Open::Kind::cases) {
    const std::string& outer = open_.back().outer_case;
    case_ = outer.empty() ? std::string(name) : fmt::format("{}.{}", outer, name);
  } else if (names_parameters_) {
    parameter_ = name;
  } else if (!open_.empty() && !open_.back().elements_of.empty()) {
    element_ = fmt::format("{}/{}", open_.back().elements_of, name);
  } else if (!element_keys_.empty() || (!open_.empty() && !open_.back().element.empty())) {
    if (std::exchange(open_.back().names_path, true)) {
      path_.pop_back();
    }
    path_.emplace_back(name);
  } else {
    element_ = name;
  }
  own_status_ = status.empty() && !open_.empty() ? open_.back().own_status : std::string(status);
}

void TableArchive::begin_object() {
  open(Open::Kind::object);
}

void TableArchive::end_object() {
  close();
}

void TableArchive::begin_map() {
  open(std::exchange(names_cases_, false) ? Open::Kind::cases : Open::Kind::map);
}

void TableArchive::end_map() {
  const Open& map = open_.back();
  if (map.names_path) {
    path_.pop_back();
  }
  if (map.kind == Open::Kind::cases) {
    case_ = map.outer_case;
  }
  element_ = map.element;
  own_status_ = map.own_status;
  close();
}

void TableArchive::begin_list() {
  open(std::exchange(names_cases_, false) ? Open::Kind::cases : Open::Kind::list);
}

void TableArchive::end_list() {
  end_map();
}

void TableArchive::quantity(const std::optional<double>& si, QuantityKind kind) {
  number(si ? std::optional(*si == 0.0 ? 0.0 : units_.from_si(kind, *si)) : std::nullopt,
         unit_of(kind));
}

std::string TableArchive::unit_of(QuantityKind kind) const {
  const auto at = std::find_if(
      open_.rbegin(), open_.rend(), [](const Open& one) { return !one.reference.empty(); });
  return is_magnitude(kind) && at != open_.rend() ? unit_quotient(units_.text(kind), at->reference)
                                                  : units_.text(kind);
}

void TableArchive::number(const std::optional<double>& value, std::string_view unit) {
  const bool is_item = begin_item();
  row(value && std::isfinite(*value) ? format_exact(*value) : "", unit);
  end_item(is_item);
}

void TableArchive::whole(std::int64_t value) {
  const bool is_item = begin_item();
  row(std::to_string(value), "");
  end_item(is_item);
}

void TableArchive::text(std::string_view value) {
  if (!properties_.empty() && properties_.back()->is_reference_unit) {
    open_.back().reference = value;
    return;
  }
  word(std::string(value), "1");
  if (std::exchange(reads_status_, false)) {
    status_ = value;
  }
}

void TableArchive::flag(bool value) {
  word("", value ? "1" : "0");
}

// An element or a word that there is not has no row.
void TableArchive::null() {
  const bool is_item = begin_item();
  const Property* property = properties_.empty() ? nullptr : properties_.back();
  if (property == nullptr ||
      (property->table_role != TableRole::element && property->table_role != TableRole::word)) {
    const auto kind = property == nullptr ? std::nullopt : kind_of(property->shape);
    row("", kind ? unit_of(*kind) : "");
  }
  end_item(is_item);
}

// A row if words have one here.
void TableArchive::word(const std::string& ending, const char* value) {
  const bool is_item = begin_item();
  if (!properties_.empty() && properties_.back()->table_role == TableRole::word) {
    path_.push_back(ending);
    row(value, "");
    path_.pop_back();
  }
  end_item(is_item);
}

bool TableArchive::has_parameters(const Property& property) const {
  return !parameters_.empty() && property.key == parameters_;
}

// What the record says of the value that comes next.
const Shape* TableArchive::next_shape() const {
  const std::size_t before = open_.empty() ? 0 : open_.back().properties;
  if (properties_.size() > before) {
    return &properties_.back()->shape;
  }
  const Shape* above = open_.empty() ? nullptr : open_.back().shape;
  return above == nullptr || above->items.empty() ? nullptr : &above->items.front();
}

void TableArchive::open(Open::Kind kind) {
  const Shape* shape = next_shape();
  const bool is_item = begin_item();
  // Of what has quantities of its own; of plain numbers the names are those of quantities.
  const bool names_elements = std::exchange(names_elements_, false) && kind != Open::Kind::object &&
                              shape != nullptr && !shape->items.empty() &&
                              shape->items.front().record != nullptr;
  open_.push_back({.kind = kind,
                   .next = 0,
                   .is_item = is_item,
                   .element = element_,
                   .own_status = own_status_,
                   .outer_case = case_,
                   .elements_of = names_elements ? element_ : std::string(),
                   .reference = {},
                   .shape = shape,
                   .properties = properties_.size()});
}

void TableArchive::close() {
  const bool is_item = open_.back().is_item;
  open_.pop_back();
  end_item(is_item);
}

// An item of a list has its number in the path, a component its name. Whether it is one.
bool TableArchive::begin_item() {
  if (open_.empty() || open_.back().kind != Open::Kind::list) {
    return false;
  }
  Open& list = open_.back();
  const auto index = static_cast<std::size_t>(list.next++);
  if (!list.elements_of.empty()) {
    element_ = fmt::format("{}/{}", list.elements_of, index);
    return false;
  }
  path_.push_back(list.shape == nullptr ? std::to_string(index)
                                        : component_name(*list.shape, index));
  return true;
}

void TableArchive::end_item(bool is_item) {
  if (is_item) {
    path_.pop_back();
  }
}

// What has no table, or no name in it, has no row, and perhaps what has no value.
void TableArchive::row(const std::string& value, std::string_view unit) {
  std::string quantity;
  for (const std::string& part : path_) {
    quantity += (quantity.empty() || part.empty() ? "" : "/") + part;
  }
  const bool is_left_out = value.empty() && missing_ == MissingNumber::no_row;
  if (pass_.empty() || quantity.empty() || is_left_out) {
    return;
  }
  std::vector<std::string> cells = {mechanism_,
                                    case_,
                                    pass_,
                                    element_,
                                    quantity,
                                    value,
                                    std::string(unit),
                                    own_status_.empty() ? status_ : own_status_};
  if (!parameters_.empty()) {
    cells.push_back(parameter_);
  }
  table(pass_).text += csv_line(cells);
}

NamedTable& TableArchive::table(const std::string& pass) {
  const auto at = std::ranges::find(tables_, pass, &NamedTable::pass);
  if (at != tables_.end()) {
    return *at;
  }
  tables_.push_back({.pass = pass, .text = std::string(kCsvHeader)});
  if (!parameters_.empty()) {
    tables_.back().text.insert(kCsvHeader.size() - 1, kParameterColumn);
  }
  return tables_.back();
}

// That of the key, or those that every case has.
void TableArchive::begin_tables(const Property& property) {
  if (property.table_role == TableRole::table || property.table_role == TableRole::table_of_cases) {
    (void)table(property.key);
  } else if (property.table_role == TableRole::cases) {
    for (const Property& one : property.shape.items.front().record->properties) {
      if (!one.is_optional) {
        begin_tables(one);
      }
    }
  }
}

}  // namespace kinestat
