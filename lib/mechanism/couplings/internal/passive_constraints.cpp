#include "mechanism/couplings/internal/passive_constraints.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "couplings/kinds.hpp"

namespace kinestat {

void keep_passive(const CouplingDescription& coupling, CouplingScrews& screws, Diagnostics& found) {
  if (!coupling.passive) {
    return;
  }
  const std::string title = fmt::format("{} '{}'", word_of(coupling.type), coupling.name.text);
  std::vector<std::string> available;
  for (const NamedWrench& constraint : screws.constraints) {
    available.push_back(constraint.name);
  }
  std::vector<std::string> kept;
  for (const Name& name : *coupling.passive) {
    if (std::ranges::find(kept, name.text) != kept.end()) {
      found.error("E0307",
                  name.where,
                  fmt::format("'passive' of {} names '{}' twice", title, name.text),
                  "remove one of the two");
    }
    kept.push_back(name.text);
    if (std::ranges::find(available, name.text) == available.end()) {
      const std::string guess = did_you_mean(name.text, available);
      found.error("E0313",
                  name.where,
                  fmt::format("{} has no constraint '{}'", title, name.text),
                  available.empty() ? "it has no passive constraints; remove 'passive'"
                                    : fmt::format("{}{}its constraints are {}",
                                                  guess,
                                                  guess.empty() ? "" : " ",
                                                  plain_list(available)));
    }
  }
  std::erase_if(screws.constraints, [&](const NamedWrench& constraint) {
    return std::ranges::find(kept, constraint.name) == kept.end();
  });
}

}  // namespace kinestat
