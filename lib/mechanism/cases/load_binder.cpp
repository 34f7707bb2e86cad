#include "mechanism/cases/load_binder.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "mechanism/cases/load_moment.hpp"

namespace kinestat {

namespace {

void warn_of_ground(const LoadDescription& load, const SectionContext& context) {
  std::vector<std::string> others;
  for (const BodyDescription& body : context.description.bodies) {
    others.push_back(body.name.text);
  }
  context.found.warning("W0301",
                        load.body.where,
                        fmt::format("load '{}' acts on the ground '{}', where it changes nothing",
                                    load.name.text,
                                    load.body.text),
                        fmt::format("name the body on which it acts: {}", plain_list(others)));
}

// A couple is one number about z in the plane.
std::optional<Vec3> couple_of(const LoadDescription& load, const SectionContext& context) {
  const std::optional<Vec3> couple = context.vector(load.couple, QuantityKind::moment);
  return couple && load.couple.size() == 1 ? Vec3(0.0, 0.0, couple->x()) : couple;
}

// Empty if it is wrong, or acts on the ground.
std::optional<Load> bind_load(const LoadDescription& load, const SectionContext& context) {
  context.names.bodies.check(
      load.body, fmt::format("load '{}' acts on", load.name.text), context.found);
  const int body = context.names.bodies.find(load.body.text);
  const std::vector<Value> none;
  const std::optional<Vec3> point =
      load.at ? context.evaluator.point(*load.at) : std::optional(Vec3(Vec3::Zero()));
  const std::optional<Vec3> force =
      context.vector(load.force ? load.force->coordinates : none, QuantityKind::force);
  const std::optional<Vec3> couple = couple_of(load, context);
  if (body == 0) {
    warn_of_ground(load, context);
  }
  if (body <= 0 || !point || !force || !couple) {
    return std::nullopt;
  }
  const Vec3 moment = load.at ? moment_of_load(*point, *force, *couple) : *couple;
  return Load{.name = load.name.text,
              .acts = {.body = BodyId{body}, .wrench = {.moment = moment, .force = *force}},
              .point = load.at ? point : std::nullopt,
              .where = load.name.where};
}

// A load as the file names it; the value is empty where nothing of it acts.
struct Named {
  std::string name;
  std::optional<Load> load;
};

std::vector<Named> bind_all(const std::vector<LoadDescription>& descriptions,
                            const SectionContext& context) {
  std::vector<Named> loads;
  for (const LoadDescription& one : descriptions) {
    loads.push_back({.name = one.name.text, .load = bind_load(one, context)});
  }
  return loads;
}

// Puts the case's own loads in the place of those of the same name, or at the end.
std::vector<Named> replaced(std::vector<Named> common, std::vector<Named> own) {
  for (Named& one : own) {
    const auto same = std::ranges::find(common, one.name, &Named::name);
    if (same == common.end()) {
      common.push_back(std::move(one));
    } else {
      *same = std::move(one);
    }
  }
  return common;
}

}  // namespace

std::vector<std::vector<Load>> bind_loads(const SectionContext& context,
                                          const std::vector<DescribedMass>& masses) {
  const std::vector<Load> weights = bind_weights(context, masses);
  const std::vector<Named> common = bind_all(context.description.loads, context);
  std::vector<std::vector<Load>> cases;
  for (const CaseDescription& one : context.description.cases) {
    std::vector<Load> loads;
    for (Named& named : replaced(common, bind_all(one.loads, context))) {
      if (named.load) {
        loads.push_back(*std::move(named.load));
      }
    }
    loads.insert(loads.end(), weights.begin(), weights.end());
    cases.push_back(std::move(loads));
  }
  return cases;
}

bool names_load(const Name& name, const CaseDescription& one, const SectionContext& context) {
  const auto has = [&](const std::vector<LoadDescription>& loads) {
    return std::ranges::any_of(
        loads, [&](const LoadDescription& load) { return load.name.text == name.text; });
  };
  const bool is_weight = name.text.starts_with(kWeightPrefix) &&
                         context.names.bodies.contains(name.text.substr(kWeightPrefix.size()));
  return has(context.description.loads) || has(one.loads) || is_weight;
}

void bind_load_ends(const SectionContext& context, std::vector<Case>& cases) {
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const CaseDescription& description = context.description.cases[c];
    const auto bind_end = [&](const std::vector<Name>& names, std::vector<std::size_t>& ends) {
      for (const Name& name : names) {
        if (context.names.actuators.contains(name.text) ||
            !names_load(name, description, context)) {
          continue;
        }
        const auto at = std::ranges::find(cases[c].loads, name.text, &Load::name);
        if (at != cases[c].loads.end()) {
          ends.push_back(static_cast<std::size_t>(at - cases[c].loads.begin()));
          continue;
        }
        context.found.error(
            "E0313",
            name.where,
            fmt::format("'{}' does not act in case '{}'", name.text, printable(cases[c].label)),
            "loads on the ground do nothing, and bodies without a mass have no weight");
      }
    };
    bind_end(description.inputs, cases[c].input_loads);
    bind_end(description.outputs, cases[c].output_loads);
  }
}

void add_loads(std::vector<std::vector<Load>> loads, std::vector<Case>& cases) {
  KINESTAT_EXPECTS(loads.size() == cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    cases[c].asks_actions = cases[c].asks_actions || !loads[c].empty();
    cases[c].loads = std::move(loads[c]);
  }
}

}  // namespace kinestat
