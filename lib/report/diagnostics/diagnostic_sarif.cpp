#include "report/diagnostics/diagnostic_sarif.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/codes.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "report/diagnostics/diagnostic_text.hpp"
#include "report/json_values.hpp"

namespace kinestat {

namespace {

std::string ascii(const Json& json) {
  return json.dump(-1, ' ', true);
}

// A reference by RFC 3986: relative as it was given, or of the scheme "file" where it is absolute.
std::string uri_of(const std::string& path) {
  constexpr std::string_view kPlain = "-._~/";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || kPlain.find(c) != std::string_view::npos;
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

// Columns of a range with an end; of the whole file nothing is said, of a line its number.
Json region_of(const SourceRange& where) {
  Json region = {{"startLine", where.line}};
  if (where.column > 0) {
    region["startColumn"] = where.column;
    region["endColumn"] = where.column + where.length;
  }
  return region;
}

Json location_of(const SourceFile& source, const SourceRange& where) {
  Json place = {{"artifactLocation", {{"uri", uri_of(source.path)}}}};
  if (where.line > 0) {
    place["region"] = region_of(where);
  }
  return {{"physicalLocation", place}};
}

Json result_of(const SourceFile& source, const Diagnostic& one) {
  const std::string hint = one.hint.empty() ? "" : fmt::format("\nhint: {}", printable(one.hint));
  Json result = {{"ruleId", one.code},
                 {"level", one.severity == Severity::error ? "error" : "warning"},
                 {"message", {{"text", printable(one.message) + hint}}}};
  if (source.path.empty() || source.path == "-") {
    return result;
  }
  result["locations"] = Json::array({location_of(source, one.where)});
  for (const Note& note : one.notes) {
    Json related = location_of(source, note.where);
    related["message"] = {{"text", printable(note.message)}};
    result["relatedLocations"].push_back(related);
  }
  return result;
}

Json rule_of(std::string_view code) {
  const Code& row = *find_code(code);
  return {{"id", row.code},
          {"shortDescription", {{"text", row.title}}},
          {"fullDescription", {{"text", row.paragraph}}},
          {"help", {{"text", fmt::format("'kinestat explain {}' has an example", row.code)}}}};
}

// One item a line.
std::string lines_of(const std::vector<std::string>& items) {
  return items.empty() ? "[]" : fmt::format("[\n{}\n]", fmt::join(items, ",\n"));
}

}  // namespace

void add_results(const SourceFile& source, const Diagnostics& found, SarifResults& results) {
  for (const Diagnostic& one : by_place(found)) {
    results.results.push_back(ascii(result_of(source, one)));
    if (std::ranges::find(results.codes, one.code) == results.codes.end()) {
      results.codes.push_back(one.code);
    }
  }
}

std::string sarif_log(const SarifResults& results, ExitStatus status) {
  std::vector<std::string> rules;
  std::ranges::transform(results.codes, std::back_inserter(rules), [](std::string_view code) {
    return ascii(rule_of(code));
  });
  const bool has_finished = status != ExitStatus::bug;
  const Json invocation = {{"executionSuccessful", has_finished},
                           {"exitCode", static_cast<int>(status)}};
  return fmt::format(
      "{{\"$schema\":\"https://json.schemastore.org/sarif-2.1.0.json\",\"version\":\"2.1.0\","
      "\"runs\":[{{\"tool\":{{\"driver\":{{\"name\":\"kinestat\",\"version\":\"{}\",\"rules\":{}}}}"
      "},\n"
      "\"columnKind\":\"unicodeCodePoints\",\"invocations\":[{}],\n"
      "\"results\":{}}}]}}\n",
      kVersion,
      lines_of(rules),
      ascii(invocation),
      lines_of(results.results));
}

}  // namespace kinestat
