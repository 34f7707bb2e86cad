#include "mechanism/cases/load_binder.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "mechanism/cases/load_moment.hpp"
#include "mechanism/curves/moving_number_binder.hpp"

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

const std::vector<Value>& force_of(const LoadDescription& load) {
  static const std::vector<Value> none;
  return load.force ? load.force->coordinates : none;
}

// Numbers that may follow curves; empty if any is wrong.
std::optional<std::array<MovingNumber, 3>> moving_vector(const std::vector<Value>& components,
                                                         std::size_t first,
                                                         QuantityKind kind,
                                                         std::span<const Curve> curves,
                                                         const SectionContext& context) {
  std::array<MovingNumber, 3> result;
  bool is_good = true;
  for (std::size_t i = 0; i < components.size(); ++i) {
    std::optional<MovingNumber> one =
        bind_moving_number(components[i], kind, curves, context.evaluator);
    is_good = is_good && one.has_value();
    if (one) {
      result[first + i] = *std::move(one);
    }
  }
  return is_good ? std::optional(std::move(result)) : std::nullopt;
}

bool follows_curves(const LoadDescription& load, const MechanismDescription& description) {
  const auto moves = [&](const Value& value) { return names_curve(value, description); };
  return std::ranges::any_of(force_of(load), moves) || std::ranges::any_of(load.couple, moves);
}

// A load as the file names it, of one of two kinds; neither is there where nothing of it acts.
struct Named {
  std::string name;
  std::optional<Load> load;
  std::optional<MovingLoad> moving;
};

class LoadBinder {
 public:
  LoadBinder(const SectionContext& context, std::span<const Curve> curves)
      : context_(context), curves_(curves) {}

  std::vector<Named> bind_all(const std::vector<LoadDescription>& descriptions) const {
    std::vector<Named> loads;
    for (const LoadDescription& one : descriptions) {
      loads.push_back(bind(one));
    }
    return loads;
  }

 private:
  Named bind(const LoadDescription& load) const {
    context_.names.bodies.check(
        load.body, fmt::format("load '{}' acts on", load.name.text), context_.found);
    const int body = context_.names.bodies.find(load.body.text);
    const std::optional<Vec3> point =
        load.at ? context_.evaluator.point(*load.at) : std::optional(Vec3(Vec3::Zero()));
    Named result{.name = load.name.text, .load = {}, .moving = {}};
    if (follows_curves(load, context_.description)) {
      result.moving = bind_moving(load, BodyId{body}, point);
    } else {
      result.load = bind_plain(load, BodyId{body}, point);
    }
    if (body == 0) {
      warn_of_ground(load, context_);
    }
    if (body <= 0) {
      result.load.reset();
      result.moving.reset();
    }
    return result;
  }

  std::optional<Load> bind_plain(const LoadDescription& load,
                                 BodyId body,
                                 const std::optional<Vec3>& point) const {
    const std::optional<Vec3> force = context_.vector(force_of(load), QuantityKind::force);
    const std::optional<Vec3> couple = couple_of(load, context_);
    if (!point || !force || !couple) {
      return std::nullopt;
    }
    const Vec3 moment = load.at ? moment_of_load(*point, *force, *couple) : *couple;
    return Load{.name = load.name.text,
                .acts = {.body = body, .wrench = {.moment = moment, .force = *force}},
                .point = load.at ? point : std::nullopt,
                .frame = load.frame,
                .where = load.name.where};
  }

  std::optional<MovingLoad> bind_moving(const LoadDescription& load,
                                        BodyId body,
                                        const std::optional<Vec3>& point) const {
    auto force = moving_vector(force_of(load), 0, QuantityKind::force, curves_, context_);
    const std::size_t first = load.couple.size() == 1 ? 2 : 0;
    auto couple = moving_vector(load.couple, first, QuantityKind::moment, curves_, context_);
    if (!point || !force || !couple) {
      return std::nullopt;
    }
    return MovingLoad{.name = load.name.text,
                      .body = body,
                      .point = load.at ? point : std::nullopt,
                      .force = *std::move(force),
                      .couple = *std::move(couple),
                      .frame = load.frame,
                      .where = load.name.where};
  }

  const SectionContext& context_;
  std::span<const Curve> curves_;
};

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

std::vector<CaseLoads> bind_loads(const SectionContext& context,
                                  const std::vector<DescribedMass>& masses,
                                  std::span<const Curve> curves) {
  const std::vector<Load> weights = bind_weights(context, masses);
  const LoadBinder binder(context, curves);
  const std::vector<Named> common = binder.bind_all(context.description.loads);
  std::vector<CaseLoads> cases;
  for (const CaseDescription& one : context.description.cases) {
    CaseLoads& now = cases.emplace_back();
    for (Named& named : replaced(common, binder.bind_all(one.loads))) {
      if (named.load) {
        now.loads.push_back(*std::move(named.load));
      }
      if (named.moving) {
        now.moving.push_back(*std::move(named.moving));
      }
    }
    now.loads.insert(now.loads.end(), weights.begin(), weights.end());
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

namespace {

// Loads that follow curves come behind the others.
std::optional<std::size_t> index_of_load(const Case& one, const std::string& name) {
  const auto at = std::ranges::find(one.loads, name, &Load::name);
  const auto moving = std::ranges::find(one.moving_loads, name, &MovingLoad::name);
  if (at == one.loads.end() && moving == one.moving_loads.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(at - one.loads.begin()) +
         (at == one.loads.end() ? static_cast<std::size_t>(moving - one.moving_loads.begin()) : 0);
}

}  // namespace

void bind_load_ends(const SectionContext& context, std::vector<Case>& cases) {
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const CaseDescription& description = context.description.cases[c];
    const auto bind_end = [&](const std::vector<Name>& names, std::vector<std::size_t>& ends) {
      for (const Name& name : names) {
        if (context.names.actuators.contains(name.text) ||
            !names_load(name, description, context)) {
          continue;
        }
        if (const auto load = index_of_load(cases[c], name.text)) {
          ends.push_back(*load);
          continue;
        }
        context.found.error(
            "E0313",
            name.where,
            fmt::format("'{}' does not act in case '{}'", name.text, printable(cases[c].label)),
            context.description.gravity || !name.text.starts_with(kWeightPrefix)
                ? "loads on the ground do nothing, and bodies without a mass have no weight"
                : fmt::format(
                      "bodies have no weight without the section gravity: [0, {}-9.81 m/s^2]",
                      context.description.space == Space::planar ? "" : "0, "));
      }
    };
    bind_end(description.inputs, cases[c].input_loads);
    bind_end(description.outputs, cases[c].output_loads);
  }
}

void add_loads(std::vector<CaseLoads> loads, std::vector<Case>& cases) {
  KINESTAT_EXPECTS(loads.size() == cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    cases[c].loads = std::move(loads[c].loads);
    cases[c].moving_loads = std::move(loads[c].moving);
    cases[c].asks_actions =
        cases[c].asks_actions || !cases[c].loads.empty() || !cases[c].moving_loads.empty();
  }
}

}  // namespace kinestat
