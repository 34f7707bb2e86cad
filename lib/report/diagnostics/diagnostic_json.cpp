#include "report/diagnostics/diagnostic_json.hpp"

#include "core/codes.hpp"
#include "core/utf8.hpp"
#include "report/diagnostics/diagnostic_text.hpp"
#include "report/json_archive.hpp"

namespace kinestat {

namespace {

struct PlacedDiagnosticView {
  const SourceFile& source;
  const Diagnostic& one;
};

std::optional<std::string> file_of(const SourceFile& source) {
  return source.path.empty() ? std::nullopt : std::optional(printable(source.path));
}

// In every object that says of a place; `where(view)`.
template <class View, class Where>
void add_place(Record<View>& keys, const Where& where) {
  keys.count("line", "Line in the file, from 1; 0 means the whole file.", [where](const View& v) {
    return where(v).line;
  });
  keys.count("column",
             "Column, from 1, counted in characters (Unicode code points); 0 means the whole line "
             "or file.",
             [where](const View& v) { return where(v).column; });
  keys.count("length",
             "Number of characters from the column on, within the line; 0 where none can be named.",
             [where](const View& v) { return where(v).length; });
}

template <class View>
void add_file(Record<View>& keys) {
  keys.text("file",
            "The path as it was given, '-' for standard input, null for the program itself. What "
            "is not a printable character is written as \\xNN.",
            [](const View& v) { return file_of(v.source); });
}

const Record<Note>& note_record() {
  static const Record<Note> record("One note.", [](Record<Note>& keys) {
    add_place(keys, [](const Note& note) { return note.where; });
    keys.text("message", "How this place is related to the message.", [](const Note& note) {
      return printable(note.message);
    });
  });
  return record;
}

void add_message(Record<PlacedDiagnosticView>& keys) {
  using View = PlacedDiagnosticView;
  keys.word("severity",
            {"error", "warning"},
            "Severity: an error prevents a result or fails a check.",
            [](const View& v) { return v.one.severity == Severity::error ? "error" : "warning"; });
  keys.text("code",
            "Stable code; 'kinestat explain CODE' explains it by an example.",
            [](const View& v) { return v.one.code; });
  keys.text("title", "The title shared by all diagnostics of this code.", [](const View& v) {
    return find_code(v.one.code)->title;
  });
  keys.text("message", "What is wrong here, with the user's names and units.", [](const View& v) {
    return printable(v.one.message);
  });
  keys.text("hint", "What to do about it; may be empty.", [](const View& v) {
    return printable(v.one.hint);
  });
}

const Record<PlacedDiagnosticView>& placed_diagnostic_record() {
  using View = PlacedDiagnosticView;
  static const Record<View> record("One diagnostic.", [](Record<View>& keys) {
    add_file(keys);
    add_place(keys, [](const View& v) { return v.one.where; });
    add_message(keys);
    keys.list("notes",
              note_record(),
              "Other places in the same file that explain the message.",
              [](const View& v, const Each<Note>& each) {
                for (const Note& note : v.one.notes) {
                  each(note);
                }
              });
  });
  return record;
}

const Record<DiagnosticsLineView>& line_form_record() {
  using View = DiagnosticsLineView;
  static const Record<View> record("The form of the line.", [](Record<View>& keys) {
    keys.count("diagnostics", "Version of this form.", [](const View&) { return 1; });
  });
  return record;
}

}  // namespace

const Record<DiagnosticsLineView>& diagnostics_line_record() {
  using View = DiagnosticsLineView;
  static const Record<View> record(
      "What a command on mechanism files writes to standard error with '--diagnostics json': JSON "
      "Lines, one object like this for each file, in the order of the files, also when there is "
      "nothing to say about it. What concerns no file, such as a wrong command line, comes as a "
      "further line whose file is null. The lines are ASCII.",
      [](Record<View>& keys) {
        keys.part("kinestat", line_form_record(), [](const View& v) { return v; });
        add_file(keys);
        keys.count("status",
                   "The exit status that this file alone asks for, 0 to 5 or 70; that of the "
                   "process is the largest of all lines.",
                   [](const View& v) { return static_cast<int>(v.status); });
        keys.list("diagnostics",
                  placed_diagnostic_record(),
                  "Errors and warnings, all of them, in the order of the file; those about the "
                  "whole file last.",
                  [](const View& v, const Each<PlacedDiagnosticView>& each) {
                    for (const Diagnostic& one : by_place(v.found)) {
                      each({.source = v.source, .one = one});
                    }
                  });
      });
  return record;
}

std::string diagnostics_line(const SourceFile& source,
                             const Diagnostics& found,
                             ExitStatus status) {
  const DiagnosticsLineView view{.source = source, .found = found, .status = status};
  const FileUnits units;  // there are no quantities
  return json_text(diagnostics_line_record(), view, units, JsonLayout::ascii_line);
}

}  // namespace kinestat
