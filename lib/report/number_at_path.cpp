#include "report/number_at_path.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "report/in_units.hpp"

namespace kinestat {

namespace {

bool is_single_number(const Property& property) {
  const bool is_number =
      property.shape.form == Shape::Form::number || property.shape.form == Shape::Form::whole;
  return is_number && !std::holds_alternative<ByContext>(property.shape.measure);
}

void collect_paths(const RecordShape& record,
                   const std::string& above,
                   std::vector<std::string>& paths) {
  for (const Property& property : record.properties) {
    const std::string path = above + property.key;
    if (!property.is_in_reports || !property.is_compared) {
      continue;
    }
    if (is_single_number(property)) {
      paths.push_back(path);
    } else if (property.shape.form == Shape::Form::object) {
      collect_paths(*property.shape.record, path + "/", paths);
    }
  }
}

const Property* property_at(const RecordShape& record, std::string_view path) {
  const std::size_t slash = path.find('/');
  const auto at = std::ranges::find_if(record.properties, [&](const Property& one) {
    return one.is_in_reports && one.key == path.substr(0, slash);
  });
  if (at == record.properties.end()) {
    return nullptr;
  }
  return slash == std::string_view::npos ? &*at
         : at->shape.form == Shape::Form::object
             ? property_at(*at->shape.record, path.substr(slash + 1))
             : nullptr;
}

}  // namespace

std::vector<std::string> number_paths(const RecordShape& record) {
  std::vector<std::string> paths;
  collect_paths(record, "", paths);
  return paths;
}

std::optional<std::string> unit_at_path(const RecordShape& record,
                                        std::string_view path,
                                        const FileUnits& units) {
  const Property* property = property_at(record, path);
  if (property == nullptr || !is_single_number(*property)) {
    return std::nullopt;
  }
  const auto* kind = std::get_if<QuantityKind>(&property->shape.measure);
  return kind != nullptr ? units.text(*kind) : std::string();
}

bool NumberAtPath::begin(const Property& property) {
  const std::size_t begin = begins_.empty() ? 0 : begins_.back();
  const std::string_view rest = path_.substr(begin);
  const bool is_on_path =
      outside_ == 0 && property.is_in_reports && rest.substr(0, rest.find('/')) == property.key;
  if (is_on_path) {
    begins_.push_back(std::min(begin + property.key.size() + 1, path_.size()));
  }
  return is_on_path;
}

void NumberAtPath::end(const Property& /*property*/) {
  begins_.pop_back();
}

void NumberAtPath::quantity(const std::optional<double>& si, QuantityKind kind) {
  number(si ? std::optional(InUnits(units_).of(kind, *si)) : std::nullopt, "");
}

void NumberAtPath::number(const std::optional<double>& value, std::string_view /*unit*/) {
  if (outside_ == 0 && !begins_.empty() && begins_.back() == path_.size()) {
    value_ = value;
  }
}

void NumberAtPath::whole(std::int64_t value) {
  number(static_cast<double>(value), "");
}

}  // namespace kinestat
