#include "report/report_keys.hpp"

namespace kinestat {

namespace {

const Record<Diagnostic>& diagnostic_record() {
  using View = Diagnostic;
  static const Record<View> record("One diagnostic.", [](Record<View>& keys) {
    keys.word("severity", {"error", "warning"}, "Its severity.", [](const View& v) {
      return v.severity == Severity::error ? "error" : "warning";
    });
    keys.text("code", "Stable code; 'kinestat explain CODE' explains it.", [](const View& v) {
      return v.code;
    });
    keys.count("line",
               "Line in the mechanism file, from 1; 0 means the whole file.",
               [](const View& v) { return v.where.line; });
    keys.count("column",
               "Column, from 1, counted in characters; 0 means the whole file.",
               [](const View& v) { return v.where.column; });
    keys.text("message", "What is wrong, with the user's names and units.", [](const View& v) {
      return v.message;
    });
    keys.text("hint", "What to do about it; may be empty.", [](const View& v) { return v.hint; });
  });
  return record;
}

}  // namespace

Shape diagnostics_shape() {
  return list_shape(object_shape(diagnostic_record(), false));
}

void write_diagnostics(const Diagnostics& found, Archive& to) {
  to.begin_list();
  for (const Diagnostic& one : found.items()) {
    diagnostic_record().write(one, to);
  }
  to.end_list();
}

}  // namespace kinestat
