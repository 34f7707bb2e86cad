#include "cases/chosen_case.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace kinestat {

const Case* choose_case(const std::vector<Case>& cases,
                        const std::string& label,
                        Diagnostics& found) {
  if (label.empty()) {
    return cases.empty() ? nullptr : &cases.front();
  }
  const auto at = std::ranges::find(cases, label, &Case::label);
  if (at != cases.end()) {
    return &*at;
  }
  std::vector<std::string> labels;
  for (const Case& one : cases) {
    labels.push_back(one.label);
  }
  refuse_case(label, labels, found);
  return nullptr;
}

void refuse_case(const std::string& label,
                 std::span<const std::string> labels,
                 Diagnostics& found) {
  found.error("E0101",
              {},
              fmt::format("--case: there is no case '{}'", printable(label)),
              labels.empty() ? "the file has no cases; leave --case out"
                             : fmt::format("{} {}",
                                           labels.size() == 1 ? "its case is" : "its cases are",
                                           quoted_list(labels)));
}

}  // namespace kinestat
