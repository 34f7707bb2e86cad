#include "report/diagnostic_json.hpp"

#include "core/codes.hpp"
#include "core/utf8.hpp"
#include "report/diagnostic_text.hpp"
#include "report/json_values.hpp"

namespace kinestat {

namespace {

Json file_of(const SourceFile& source) {
  return source.path.empty() ? Json(nullptr) : Json(printable(source.path));
}

void add_place(const SourceRange& where, Json& entry) {
  entry["line"] = where.line;
  entry["column"] = where.column;
  entry["length"] = where.length;
}

Json entry_of(const SourceFile& source, const Diagnostic& one) {
  Json entry;
  entry["file"] = file_of(source);
  add_place(one.where, entry);
  entry["severity"] = one.severity == Severity::error ? "error" : "warning";
  entry["code"] = one.code;
  entry["title"] = find_code(one.code)->title;
  entry["message"] = printable(one.message);
  entry["hint"] = printable(one.hint);
  entry["notes"] = Json::array();
  for (const Note& note : one.notes) {
    Json more;
    add_place(note.where, more);
    more["message"] = printable(note.message);
    entry["notes"].push_back(std::move(more));
  }
  return entry;
}

}  // namespace

std::string diagnostics_line(const SourceFile& source,
                             const Diagnostics& found,
                             ExitStatus status) {
  Json line;
  line["kinestat"]["diagnostics"] = 1;
  line["file"] = file_of(source);
  line["status"] = static_cast<int>(status);
  line["diagnostics"] = Json::array();
  for (const Diagnostic& one : by_place(found)) {
    line["diagnostics"].push_back(entry_of(source, one));
  }
  constexpr bool kAscii = true;
  return line.dump(-1, ' ', kAscii) + "\n";
}

}  // namespace kinestat
