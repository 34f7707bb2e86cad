#include "report/published.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/json_pointer.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// What --set says in place of the file.
std::string set_numbers(const MechanismDescription& description) {
  std::string all;
  for (const ParameterDescription& one : description.parameters) {
    all +=
        one.set_by.empty() ? "" : fmt::format("{}--set '{}'", all.empty() ? "" : ", ", one.set_by);
  }
  return all;
}

void miss(const PublishedValue& published,
          double value,
          const std::string& set,
          Diagnostics& found) {
  found.error("E0901",
              published.is_where,
              fmt::format("published value {} is missed: {} is {}, off by {} (tolerance {}{}{})",
                          format_exact(published.is),
                          published.pointer.text,
                          format_exact(value),
                          format_short(value - published.is),
                          format_short(published.tolerance),
                          published.where.empty() ? "" : "; ",
                          published.where),
              set.empty() ? "check the model against the source, and the source against its errata"
                          : fmt::format("the value is that of the file as it is, without {}", set));
}

}  // namespace

WantedKeys keys_of(const std::vector<PublishedValue>& published) {
  WantedKeys keys;
  for (const PublishedValue& one : published) {
    std::string_view rest = one.pointer.text;
    WantedKeys* at = &keys;
    while (rest.starts_with('/')) {
      at = &at->with(take_token(rest));
    }
  }
  return keys;
}

void check_published(const Json& report,
                     const MechanismDescription& description,
                     Diagnostics& found) {
  for (const PublishedValue& one : description.published) {
    const PointerTarget target = follow_pointer(report, one.pointer.text);
    if (target.value == nullptr) {
      found.error("E0902", one.pointer.where, target.problem, target.hint);
    } else if (!target.value->is_number()) {
      found.error(
          "E0902",
          one.pointer.where,
          fmt::format("'{}' is {}, not a number", one.pointer.text, kind_of_json(*target.value)),
          target.value->is_null() ? "the case has no answer there; see its status"
                                  : "let the pointer lead to a single number of the report");
    } else if (const double value = target.value->get<double>();
               !(std::abs(value - one.is) <= one.tolerance)) {
      miss(one, value, set_numbers(description), found);
    }
  }
}

}  // namespace kinestat
