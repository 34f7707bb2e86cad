// The forms in which the report of one file is written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/text_blocks.hpp"

namespace kinestat {

/// One CSV table under the name of its pass.
struct NamedTable {
  std::string pass;
  std::string text;
};

/// Which forms are wanted; the others stay empty.
struct ReportForms {
  bool json = false;
  bool json_line = false;  ///< the same on one line, for several files on one stream
  bool csv = false;
  bool text = false;
};

struct FileReport {
  std::string json;
  std::string json_line;
  std::vector<NamedTable> csv;
  TextBlocks text;
};

/// What every JSON report of this program begins with; a file that begins otherwise is foreign.
std::string_view json_signature();

/// What every CSV table of this program begins with.
std::string_view csv_signature();

}  // namespace kinestat
