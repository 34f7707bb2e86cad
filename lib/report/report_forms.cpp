#include "report/report_forms.hpp"

#include "report/table_archive.hpp"

namespace kinestat {

std::string_view json_signature() {
  return "{\n  \"kinestat\": {";
}

std::string_view csv_signature() {
  // What those of all layouts have.
  return kCsvHeader.substr(0, kCsvHeader.find("pass"));
}

}  // namespace kinestat
