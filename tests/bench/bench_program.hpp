// What the benchmark programs have in common: their options, and how they end.
#pragma once

#include <functional>
#include <string>

#include "ratio_table.hpp"

namespace kinestat::bench {

struct Options {
  int rounds = 300;  ///< how often each job is timed
  TableForm form = TableForm::text;
};

/// Reads [--rounds N] [--csv], and prints what `measure` returns; a wrong command line, and what
/// `measure` throws, go to standard error. Returns the exit status.
int run_program(const std::string& name,
                int argc,
                char** argv,
                const std::function<std::string(const Options&)>& measure);

}  // namespace kinestat::bench
