#include "mechanism/unanalysed.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "couplings/kinds.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "mechanism/couplings/internal/friction_binder.hpp"

namespace kinestat {

namespace {

bool asks_statics(const MechanismDescription& description) {
  const bool has_loads = !description.loads.empty() || description.gravity;
  if (description.shift && (has_loads || !description.shift->input_action.empty())) {
    return true;
  }
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
  const char* const point = description.space == Space::planar ? "[x, y]" : "[x, y, z]";
  list.push_back(
      {.where = first->name.where,
       .what = fmt::format("{} needs {} in the drawn position{}",
                           word(*first),
                           is_cable ? "'from' and 'to', its ends" : "'at', its point",
                           count == 1   ? ""
                           : count == 2 ? ", and 1 more needs its place"
                                        : fmt::format(", and {} more need theirs", count - 1)),
       .hint = fmt::format(
           "write {}; 'kinestat mobility' counts freedoms without it",
           is_cable ? fmt::format("from: {0} and to: {0}", point) : fmt::format("at: {}", point)),
       .decides = true,
       .can_be_counted = true});
}

// Whether the states of `shift` decide it.
bool is_shifted(const MechanismDescription& description, const CouplingDescription& coupling) {
  return description.shift &&
         std::ranges::any_of(description.shift->elements, [&](const Name& element) {
           return element.text == coupling.name.text;
         });
}

void add_coupling(const CouplingDescription& coupling,
                  bool is_shift_element,
                  bool has_statics,
                  std::vector<Unanalysed>& list) {
  const auto add = [&](SourceRange where, std::string what, std::string hint, bool decides) {
    list.push_back(
        {.where = where, .what = std::move(what), .hint = std::move(hint), .decides = decides});
  };
  if (coupling.at && !coupling.at->of_bodies.empty()) {
    add(coupling.at->where,
        fmt::format("{} has a point on each of its bodies", word(coupling)),
        "it says how far each body moves and, where points alone were "
        "wrong, which to draw for the other analyses; or write one point after 'at:', where both "
        "bodies are drawn to meet",
        true);
    list.back().is_closure_error = true;
  }
  if (coupling.one_way && !is_shift_element) {
    add(coupling.name.where,
        fmt::format("freewheel {}", word(coupling)),
        fmt::format(
            "name it in 'elements' of 'shift'; or remove 'one_way', and each case says whether it "
            "is engaged, motion: {{{0}: 0}}, or open, action: {{{0}: 0}}",
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

}  // namespace

std::vector<Unanalysed> find_unanalysed(const MechanismDescription& description) {
  std::vector<Unanalysed> list;
  const bool has_statics = asks_statics(description);
  add_missing_places(description, list);
  for (const CouplingDescription& coupling : description.couplings) {
    add_coupling(coupling, is_shifted(description, coupling), has_statics, list);
  }
  return list;
}

}  // namespace kinestat
