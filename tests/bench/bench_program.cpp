#include "bench_program.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace kinestat::bench {

namespace {

Options read_options(const std::string& name, int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--csv") {
      options.form = TableForm::csv;
    } else if (word == "--rounds" && i + 1 < argc) {
      options.rounds = std::max(1, std::atoi(argv[++i]));
    } else {
      throw std::runtime_error("usage: " + name + " [--rounds N] [--csv]");
    }
  }
  return options;
}

}  // namespace

int run_program(const std::string& name,
                int argc,
                char** argv,
                const std::function<std::string(const Options&)>& measure) {
  try {
    const std::string text = measure(read_options(name, argc, argv));
    std::fwrite(text.data(), 1, text.size(), stdout);
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), problem.what());
    return 1;
  }
}

}  // namespace kinestat::bench
