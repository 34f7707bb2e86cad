#include "studies/benchmark/report/benchmark_record.hpp"

#include "report/report_keys.hpp"
#include "studies/benchmark/trade_off_record.hpp"

namespace kinestat {

namespace {

const Record<BenchmarkedCase>& benchmarked_case_record() {
  using View = BenchmarkedCase;
  static const Record<View> record("One case of the file.", [](Record<View>& keys) {
    keys.part(
        "motion", trade_off_record(), "Its velocities.", [](const View& v) -> const TradeOff& {
          return v.motion;
        });
    keys.part("action",
              trade_off_record(),
              "Its actions, without friction and losses.",
              [](const View& v) -> const TradeOff& { return v.action; });
  });
  return record;
}

}  // namespace

const Record<BenchmarkReportView>& benchmark_report_record() {
  using View = BenchmarkReportView;
  static const Record<View> record(
      "What 'kinestat bench --format json' writes: time and error of the solution methods in "
      "extreme cases.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.text("unit",
                  "The unit of the times.",
                  [](const View&) { return "Eigen PartialPivLU, double, dense"; })
            .not_in_tables();
        keys.map("bench",
                 benchmarked_case_record(),
                 "Each case by its label.",
                 [](const View& v, const Each<BenchmarkedCase>& each) {
                   for (const BenchmarkedCase& one : v.cases) {
                     each(one.label, one);
                   }
                 })
            .in_tables_is(TableRole::table_of_cases);
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
