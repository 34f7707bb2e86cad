#include "files/output.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace kinestat {

std::string report_stem(const std::string& path) {
  if (path == "-") {
    return "stdin";
  }
  std::string name = path.substr(path.rfind('/') + 1);
  for (const std::string_view ending : {".yaml", ".yml"}) {
    if (name.size() > ending.size() && name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
      break;
    }
  }
  return name;
}

bool check_distinct(const std::vector<std::string>& paths, Diagnostics& found) {
  std::map<std::string, std::string> seen;
  bool is_good = true;
  for (const std::string& path : paths) {
    const auto [at, is_new] = seen.emplace(report_stem(path), path);
    if (!is_new) {
      is_good = false;
      found.error(
          "E0101",
          {},
          fmt::format("the reports of '{}' and '{}' would have the same name", at->second, path),
          "analyse them into different folders");
    }
  }
  return is_good;
}

std::string laid_out(const std::string& tidy, TableLayout layout) {
  return layout == TableLayout::wide ? wide_table(tidy) : tidy;
}

bool write_report(const FileReport& report,
                  const std::string& stem,
                  const OutputOptions& options,
                  InputPaths inputs,
                  Diagnostics& found) {
  std::vector<OutputFile> files;
  files.push_back({.path = fmt::format("{}/{}.report.json", options.folder, stem),
                   .content = report.json,
                   .signature = std::string(json_signature())});
  for (const NamedTable& table : report.csv) {
    files.push_back({.path = fmt::format("{}/{}.{}.csv", options.folder, stem, table.pass),
                     .content = laid_out(table.text, options.layout),
                     .signature = std::string(csv_signature())});
  }
  return write_files(files, options.overwrite, inputs, found);
}

}  // namespace kinestat
