// What commands on mechanism files have in common.
#pragma once

#include "core/accuracy.hpp"
#include "files/load_file.hpp"
#include "files/outcome.hpp"
#include "files/output.hpp"

namespace kinestat {

/// What goes to standard output.
enum class StreamFormat { table, json, csv };

struct AnalyseOptions {
  LoadOptions load;
  StreamFormat format = StreamFormat::table;
  OutputOptions output;
  Strictness strictness = Strictness::normal;
  DiagnosticsForm diagnostics = DiagnosticsForm::text;
  AccuracyRequest accuracy{.accuracy = Accuracy::automatic};
  bool is_quiet = false;   ///< no table on standard output
  bool fail_fast = false;  ///< stop after the first file that fails
};

}  // namespace kinestat
