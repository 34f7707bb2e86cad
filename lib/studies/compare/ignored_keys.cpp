#include "studies/compare/ignored_keys.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "report/kinds/report_kinds.hpp"
#include "studies/compare/compare_place.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

namespace {

using Names = std::set<std::string, std::less<>>;

// Every key of the record and below it, each record once, with the key above, which is empty at the
// top; `visit` answers whether to go below.
using Visit = std::function<bool(const Property&, const std::string& above)>;

void visit_keys(const RecordShape& record,
                const std::string& above,
                std::set<const RecordShape*>& seen,
                const Visit& visit) {
  if (!seen.insert(&record).second) {
    return;
  }
  for (const Property& property : record.properties) {
    const std::function<void(const Shape&)> descend = [&](const Shape& shape) {
      if (shape.record != nullptr) {
        visit_keys(*shape.record, property.key, seen, visit);
      }
      std::ranges::for_each(shape.items, descend);
    };
    if (visit(property, above)) {
      descend(property.shape);
    }
  }
}

void visit_reports(const Visit& visit) {
  std::set<const RecordShape*> seen;
  for (const ReportKind& kind : report_kinds()) {
    visit_keys(*kind.record, "", seen, visit);
  }
}

Names find_names_in_tables() {
  Names ignored = {std::string(kClosureErrorColumn)};
  visit_reports([&](const Property& property, const std::string&) {
    if (property.is_in_tables && !property.is_compared) {
      ignored.insert(property.table_quantity);
    }
    return property.is_in_tables;
  });
  visit_reports([&](const Property& property, const std::string&) {
    if (property.is_compared) {
      ignored.erase(property.table_quantity);
    }
    return true;
  });
  return ignored;
}

Names find_names_in_reports() {
  Names compared;
  std::set<std::pair<std::string, std::string>> ignored;  // key, that above
  visit_reports([&](const Property& property, const std::string& above) {
    if (property.is_compared) {
      compared.insert(property.key);
    } else if (property.is_in_reports) {
      ignored.emplace(property.key, above);
    }
    return property.is_compared;
  });
  Names names;
  for (const auto& [key, above] : ignored) {
    names.insert(compared.contains(key) && !above.empty() ? fmt::format("{}/{}", above, key) : key);
  }
  return names;
}

}  // namespace

bool is_compared_in_tables(std::string_view quantity) {
  static const Names ignored = find_names_in_tables();
  const std::string place = fmt::format("/{}", quantity);
  return std::ranges::none_of(keys_of(place),
                              [](std::string_view one) { return ignored.contains(one); });
}

std::vector<std::string> ignored_keys() {
  const Names names = find_names_in_reports();
  return {names.begin(), names.end()};
}

}  // namespace kinestat
