#include "core/contract.hpp"

#include <string>
#include <string_view>

namespace kinestat {

namespace {

// The part of the path that a reader of the sources recognises, e.g. "graph/digraph.cpp".
std::string_view short_path(std::string_view path) {
  const auto at = path.rfind("/lib/");
  return at == std::string_view::npos ? path : path.substr(at + 5);
}

}  // namespace

ContractViolation::ContractViolation(const char* condition, const char* file, int line)
    : std::logic_error(std::string(short_path(file)) + ":" + std::to_string(line) + ": expected " +
                       condition) {}

}  // namespace kinestat
