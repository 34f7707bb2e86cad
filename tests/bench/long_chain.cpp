#include "long_chain.hpp"

#include <fmt/format.h>

namespace kinestat::bench {

std::string long_chain(int count) {
  std::string parameters = "parameters:\n";
  std::string bodies = "bodies: [";
  std::string couplings = "couplings:\n";
  for (int i = 1; i <= count; ++i) {
    parameters += fmt::format("  p{0}: ({0} + {1}/8) * 1 mm\n", i, i % 8);
    bodies += fmt::format("{}b{}", i == 1 ? "" : ", ", i);
    couplings += fmt::format(
        "  c{0}: {{type: revolute, bodies: [b{1}, b{0}], at: [p{0}, {0} mm]}}\n", i, i - 1);
  }
  return "kinestat: 1\nspace: planar\nground: b0\n" + parameters + bodies + "]\n" + couplings;
}

}  // namespace kinestat::bench
