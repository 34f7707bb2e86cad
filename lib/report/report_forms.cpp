#include "report/report_forms.hpp"

#include "report/table_archive.hpp"

namespace kinestat {

std::string_view json_signature() {
  return "{\n  \"kinestat\": {";
}

std::string_view csv_signature() {
  // Tables may have more columns.
  return kCsvHeader.substr(0, kCsvHeader.size() - 1);
}

}  // namespace kinestat
