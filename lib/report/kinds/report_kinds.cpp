#include "report/kinds/report_kinds.hpp"

#include <algorithm>
#include <array>

#include "report/file/report_record.hpp"
#include "studies/benchmark/report/benchmark_record.hpp"
#include "studies/duty/report/duty_record.hpp"
#include "studies/inputs/report/inputs_record.hpp"
#include "studies/mobility/report/mobility_record.hpp"
#include "studies/sensitivity/report/sensitivity_record.hpp"
#include "studies/simulation/report/simulation_record.hpp"
#include "studies/synthesis/report/synthesis_record.hpp"
#include "studies/tolerance/report/tolerance_record.hpp"
#include "studies/transmissions/report/transmission_record.hpp"

namespace kinestat {

namespace {

// Whether the report has no other keys, and all that it must have.
bool has_keys_of(const RecordShape& record, const Json& report) {
  const auto is_known = [&](const auto& item) {
    return std::ranges::find(record.properties, item.key(), &Property::key) !=
           record.properties.end();
  };
  const auto keys = report.items();
  return std::all_of(keys.begin(), keys.end(), is_known) &&
         std::ranges::all_of(record.properties, [&](const Property& property) {
           return property.is_optional || report.contains(property.key);
         });
}

}  // namespace

std::span<const ReportKind> report_kinds() {
  static const std::array<ReportKind, 10> kinds = {{{"bench", &benchmark_report_record()},
                                                    {"duty", &duty_report_record()},
                                                    {"inputs", &inputs_report_record()},
                                                    {"mobility", &mobility_report_record()},
                                                    {"sensitivity", &sensitivity_report_record()},
                                                    {"simulation", &simulation_report_record()},
                                                    {"tolerance", &tolerance_report_record()},
                                                    {"synthesis", &synthesis_report_record()},
                                                    {"transmission", &transmission_report_record()},
                                                    {"report", &report_record()}}};
  return kinds;
}

const RecordShape& record_of(const Json& report) {
  for (const ReportKind& kind : report_kinds()) {
    if (has_keys_of(*kind.record, report)) {
      return *kind.record;
    }
  }
  return report_record();
}

}  // namespace kinestat
