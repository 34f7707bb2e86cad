#include "mechanism/unanalysed.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "mechanism/internal/friction_binder.hpp"
#include "mechanism/internal/geometry_check.hpp"

namespace kinestat {

namespace {

bool asks_statics(const MechanismDescription& description) {
  const bool has_loads = !description.loads.empty() || description.gravity;
  return std::ranges::any_of(description.cases, [&](const CaseDescription& one) {
    return one.asks_actions || has_loads || !one.loads.empty();
  });
}

std::string word(const CouplingDescription& coupling) {
  return fmt::format("{} '{}'", word_of(coupling.type), coupling.name.text);
}

// One for the file, at the first coupling without a place.
void add_missing_places(const MechanismDescription& description, std::vector<Unanalysed>& list) {
  const auto count = std::ranges::count_if(description.couplings, is_counted_only);
  if (count == 0) {
    return;
  }
  const auto first = std::ranges::find_if(description.couplings, is_counted_only);
  const bool is_cable = first->type == CouplingType::cable;
  list.push_back(
      {.where = first->name.where,
       .what = fmt::format("{} has no {}{}, and a file that can only be counted",
                           word(*first),
                           is_cable ? "'from' and 'to'" : "'at'",
                           count == 1 ? "" : fmt::format(", nor have {} more a place", count - 1)),
       .hint = fmt::format("add {}; 'kinestat mobility' counts the file as it is",
                           is_cable ? "from: and to:, its ends on the tail and on the head"
                                    : "'at', the point of the coupling in the drawn position"),
       .decides = true,
       .can_be_counted = true});
}

void add_coupling(const CouplingDescription& coupling,
                  bool has_statics,
                  std::vector<Unanalysed>& list) {
  const auto add = [&](SourceRange where, std::string what, std::string hint, bool decides) {
    list.push_back(
        {.where = where, .what = std::move(what), .hint = std::move(hint), .decides = decides});
  };
  if (coupling.at && !coupling.at->of_bodies.empty()) {
    add(coupling.at->where,
        fmt::format("misclosure of {}", word(coupling)),
        "write one point after 'at:', where both bodies are drawn to meet",
        true);
  }
  if (coupling.at && coupling.at->along_axis) {
    add(coupling.at->where,
        fmt::format("position of {} along its axis alone", word(coupling)),
        "write the whole point, at: [x, y, z]",
        true);
  }
  if (coupling.one_way) {
    add(coupling.name.where,
        fmt::format("freewheel {}", word(coupling)),
        fmt::format(
            "remove 'one_way'; each case says whether it is engaged, motion: {{{0}: 0}}, or "
            "open, action: {{{0}: 0}}",
            coupling.name.text),
        true);
  }
  if (coupling.friction && !has_friction_law(coupling)) {
    add(coupling.friction->where,
        fmt::format("friction of {}", word(coupling)),
        "remove it; 'kinestat help friction' lists the types whose friction is analysed",
        has_statics);
  }
}

void add_model_sections(const MechanismDescription& description, std::vector<Unanalysed>& list) {
  if (description.gears) {
    list.push_back({description.gears->where,
                    "section 'gears'",
                    "write each mesh as a coupling of type gear: 'kinestat help couplings'",
                    true});
  }
}

void add_passes(const MechanismDescription& description, std::vector<Unanalysed>& list) {
  if (description.losses) {
    list.push_back({description.losses->where, "section 'losses'", "", false});
  }
  if (description.shift) {
    list.push_back({description.shift->where, "section 'shift'", "", false});
  }
  if (description.motion) {
    list.push_back({description.motion->where, "section 'motion'", "", false});
  }
  if (description.synthesis) {
    list.push_back({description.synthesis->where, "section 'synthesis'", "", false});
  }
}

}  // namespace

std::vector<Unanalysed> find_unanalysed(const MechanismDescription& description) {
  std::vector<Unanalysed> list;
  const bool has_statics = asks_statics(description);
  add_missing_places(description, list);
  for (const CouplingDescription& coupling : description.couplings) {
    add_coupling(coupling, has_statics, list);
  }
  add_model_sections(description, list);
  add_passes(description, list);
  return list;
}

}  // namespace kinestat
