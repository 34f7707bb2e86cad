#include "mechanism/couplings/internal/screw_binder.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "core/utf8.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/couplings/reciprocity.hpp"

namespace kinestat {

CouplingScrews ScrewBinder::drawn(const CouplingGeometry& local,
                                  double length,
                                  Diagnostics& found) const {
  CouplingScrews screws = coupling_screws(coupling_.type, drawn_in_, local);
  check_reciprocal(screws, length, found);
  keep_passive(coupling_, screws, found);
  return screws;
}

CouplingScrews ScrewBinder::counted(const CouplingGeometry& local,
                                    const CouplingScrews& drawn) const {
  const auto is_drawn = [&](Space space) { return coupling_.passive || space == drawn_in_; };
  CouplingScrews screws = drawn;
  if (!is_drawn(spaces_.motions)) {
    screws.freedoms = coupling_screws(coupling_.type, spaces_.motions, local).freedoms;
  }
  if (!is_drawn(spaces_.actions)) {
    screws.constraints = coupling_screws(coupling_.type, spaces_.actions, local).constraints;
  }
  return screws;
}

// A coupling whose actions work on its freedoms would be a source of power.
void ScrewBinder::check_reciprocal(const CouplingScrews& screws,
                                   double length,
                                   Diagnostics& found) const {
  const double error = reciprocity_error(screws, length);
  if (error > kPowerBalance) {
    found.error(
        "E0314",
        coupling_.name.where,
        fmt::format("the actions of {} '{}' do work on its freedoms: {:.2g} of their magnitude",
                    word_of(coupling_.type),
                    coupling_.name.text,
                    error),
        coupling_.type == CouplingType::screws
            ? "list freedoms or constraints alone; the others follow from them"
            : "the line of action is perpendicular to the velocity at which the teeth "
              "slide; write expressions instead of rounded numbers");
  }
}

void check_stiffness(const CouplingDescription& coupling,
                     const CouplingScrews& screws,
                     Diagnostics& found) {
  std::vector<std::string> names;
  for (const NamedWrench& constraint : screws.constraints) {
    names.push_back(constraint.name);
  }
  for (const StiffnessDescription& one : coupling.stiffness) {
    if (std::ranges::find(names, one.action.text) == names.end()) {
      found.error("E0313",
                  one.action.where,
                  fmt::format("coupling '{}' has no constraint '{}'",
                              coupling.name.text,
                              printable(one.action.text)),
                  fmt::format("its constraints are {}", plain_list(names)));
    }
  }
}

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
      found.error(
          "E0313",
          name.where,
          fmt::format("{} has no constraint '{}'", title, name.text),
          available.empty()
              ? "it has no passive constraints; remove 'passive'"
              : guess_before(name.text, available, "its constraints are " + plain_list(available)));
    }
  }
  std::erase_if(screws.constraints, [&](const NamedWrench& constraint) {
    return std::ranges::find(kept, constraint.name) == kept.end();
  });
}

}  // namespace kinestat
