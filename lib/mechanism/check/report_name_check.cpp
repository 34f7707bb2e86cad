#include "mechanism/check/report_name_check.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "mechanism/cases/load.hpp"
#include "mechanism/motion_column_names.hpp"
#include "mechanism/motion_figure.hpp"
#include "mechanism/motion_plan.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kMotionSection = "motion";

// All that a report may name without a dot.
std::vector<std::string> undotted(std::span<const std::string> words,
                                  std::string_view section,
                                  const SectionContext& context) {
  std::vector<std::string> candidates(words.begin(), words.end());
  const auto actuators = context.names.actuators.names();
  candidates.insert(candidates.end(), actuators.begin(), actuators.end());
  if (section == kMotionSection) {
    const std::vector<std::string> elements =
        elements_of_motion(context.description, context.names.bodies.names());
    candidates.insert(candidates.end(), elements.begin(), elements.end());
  }
  return candidates;
}

// Which columns a motion has shows once it is made: "motor/action", "pen.velocity", "coupler".
bool names_motion_column(const Name& name,
                         std::string_view section,
                         const SectionContext& context) {
  if (section != kMotionSection) {
    return false;
  }
  if (name.text.find('/') != std::string::npos || context.names.couplings.contains(name.text)) {
    return true;
  }
  const std::size_t dot = name.text.find('.');
  if (dot != std::string::npos && context.names.couplings.contains(name.text.substr(0, dot))) {
    return false;
  }
  std::vector<std::string> elements =
      elements_of_motion(context.description, context.names.bodies.names());
  const auto actuators = context.names.actuators.names();
  elements.insert(elements.end(), actuators.begin(), actuators.end());
  return std::ranges::any_of(elements, [&](const std::string& element) {
    return name.text.starts_with(element) &&
           (name.text.size() == element.size() || name.text[element.size()] == '.');
  });
}

std::string coupling_of(const Name& name) {
  return name.text.substr(0, name.text.find('.'));
}

// "lossy.out": what an actuator does where meshes lose power, of which a sweep has columns.
bool names_lossy_actuator(const Name& name,
                          std::string_view section,
                          const SectionContext& context) {
  constexpr std::string_view kPrefix = "lossy.";
  return section == "sweep" && name.text.starts_with(kPrefix) &&
         !context.names.couplings.contains("lossy") &&
         context.names.actuators.contains(name.text.substr(kPrefix.size()));
}

// The words of `words` that people also call so: "torque" is an action. Of several the first is
// what the parts have one by one.
std::string otherwise_called(std::string_view name, std::span<const std::string> words) {
  struct Other {
    std::string_view called;
    std::string_view word;
  };

  constexpr auto kOthers = std::to_array<Other>({{"torque", "action"},
                                                 {"moment", "action"},
                                                 {"couple", "action"},
                                                 {"force", "action"},
                                                 {"force", "reaction"},
                                                 {"friction", "reaction"},
                                                 {"loss", "reaction"},
                                                 {"speed", "velocity"},
                                                 {"angle", "position"}});
  std::vector<std::string> meant;
  for (const Other& other : kOthers) {
    const bool is_called = name.starts_with(other.called) &&
                           (name == other.called || name.substr(other.called.size()) == "s" ||
                            name.substr(other.called.size()) == "es");
    if (is_called && std::ranges::find(words, other.word) != words.end()) {
      meant.push_back(fmt::format("'{}'", other.word));
    }
  }
  return meant.empty() ? "" : fmt::format("did you mean {}? ", fmt::join(meant, " or "));
}

// "d.wz.position.range", of which a sweep has columns where there is a motion; which columns that
// has shows once it is made. Answers whether the name is of that kind, right or wrong.
bool names_motion_figure(const Name& name,
                         std::string_view section,
                         const SectionContext& context) {
  if (section != "sweep") {
    return false;
  }
  const auto words = motion_figure_words();
  if (motion_figure_of(name.text)) {
    if (!context.description.motion) {
      context.found.error(
          "E0303",
          name.where,
          fmt::format("'{}' is of a whole motion, and the file has no section 'motion'", name.text),
          "add for example motion: {drive: NAME, to: 360 deg}");
    }
    return true;
  }
  const std::size_t last = name.text.rfind('.');
  if (std::ranges::count(name.text, '.') < 2) {
    return false;
  }
  context.found.error("E0313",
                      name.where,
                      fmt::format("'{}' does not end in a figure of a motion", name.text),
                      guess_before(name.text.substr(last + 1),
                                   words,
                                   fmt::format("end it in one of {}", plain_list(words))));
  return true;
}

}  // namespace

std::vector<std::string> elements_of_motion(const MechanismDescription& description,
                                            std::span<const std::string> bodies) {
  std::vector<std::string> all(bodies.begin(), bodies.end());
  all.insert(all.end(), {std::string(kTimeColumn), std::string(kClosureErrorColumn)});
  all.insert(all.end(), kColumnsOfDynamics.begin(), kColumnsOfDynamics.end());
  const auto add_loads = [&all](const std::vector<LoadDescription>& loads) {
    for (const LoadDescription& load : loads) {
      all.push_back(load.name.text);
    }
  };
  add_loads(description.loads);
  for (const CaseDescription& one : description.cases) {
    add_loads(one.loads);
  }
  for (const BodyDescription& body : description.bodies) {
    if (body.mass && description.gravity) {
      all.push_back(std::string(kWeightPrefix) + body.name.text);
    }
  }
  for (const SpringDescription& spring : description.springs) {
    all.push_back(std::string(kSpringPrefix) + spring.name.text);
  }
  const std::vector<TracePoint>& trace = description.motion->trace;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    all.push_back(name_of_trace(trace, i));
  }
  return all;
}

bool is_report_path(std::string_view name) {
  return name.find('/') != std::string_view::npos && !motion_figure_of(name);
}

std::span<const std::string> sweep_report_words() {
  static const std::vector<std::string> kWords = {"ratio",
                                                  "torque_ratio",
                                                  "step",
                                                  "efficiency",
                                                  "recirculation",
                                                  "limit_use",
                                                  std::string(kEquivalentInertiaWord)};
  return kWords;
}

void check_report_names(const std::vector<Name>& names,
                        std::span<const std::string> words,
                        std::string_view section,
                        const SectionContext& context) {
  const std::string role = fmt::format("'report' of '{}'", section);
  for (const Name& name : names) {
    if (names_lossy_actuator(name, section, context) ||
        names_motion_figure(name, section, context) ||
        names_motion_column(name, section, context) ||
        (section == "sweep" && is_report_path(name.text))) {
      continue;
    }
    if (section == kMotionSection && name.text.starts_with(kSpringPrefix) &&
        !context.names.couplings.contains(coupling_of(name))) {
      std::vector<std::string> springs;
      for (const SpringDescription& spring : context.description.springs) {
        springs.push_back(std::string(kSpringPrefix) + spring.name.text);
      }
      context.found.error("E0313",
                          name.where,
                          fmt::format("{} names '{}', and no spring is called so", role, name.text),
                          guess_before(name.text, springs, "springs are " + plain_list(springs)));
      continue;
    }
    if (name.text.find('.') != std::string::npos) {
      const Name coupling = {.text = coupling_of(name), .where = name.where};
      context.names.couplings.check(coupling, role + " names", context.found);
      continue;
    }
    const bool is_known = std::ranges::find(words, name.text) != words.end() ||
                          context.names.actuators.contains(name.text);
    if (!is_known) {
      const std::vector<std::string> guesses = context.found.is_hint_worth_it()
                                                   ? undotted(words, section, context)
                                                   : std::vector<std::string>();
      const std::string rest = fmt::format(
          "write one of {}, an actuator{}, or coupling.freedom or coupling.action, "
          "for example a.wz{}",
          plain_list(words),
          section == kMotionSection ? ", a coupling" : "",
          section == kMotionSection ? "; or a column that the motion has, for example motor/action"
                                    : "");
      const auto whole = std::ranges::find_if(
          guesses, [&](const std::string& one) { return one.ends_with("." + name.text); });
      const std::string other = whole != guesses.end() ? fmt::format("did you mean '{}'? ", *whole)
                                                       : otherwise_called(name.text, words);
      context.found.error("E0313",
                          name.where,
                          fmt::format("{} cannot hold '{}'", role, name.text),
                          other.empty() ? guess_before(name.text, guesses, rest) : other + rest);
    }
  }
  context.repeats(names, role);
}

void check_report_quantities(const std::vector<Name>& names,
                             bool have_columns,
                             const Topology& topology,
                             Diagnostics& found) {
  std::map<std::string, std::vector<std::string>> by_coupling;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    const auto c =
        static_cast<std::size_t>(topology.freedoms[static_cast<std::size_t>(f)].coupling.value);
    by_coupling[topology.couplings[c].name].push_back(topology.freedom_name(f));
  }
  for (int a = 0; a < topology.action_count(); ++a) {
    const auto c =
        static_cast<std::size_t>(topology.actions[static_cast<std::size_t>(a)].coupling.value);
    by_coupling[topology.couplings[c].name].push_back(topology.action_name(a));
  }
  for (const Name& name : names) {
    const auto at = by_coupling.find(coupling_of(name));
    if (name.text.find('.') == std::string::npos || at == by_coupling.end() ||
        std::ranges::find(at->second, name.text) != at->second.end()) {
      continue;
    }
    found.error(
        "E0313",
        name.where,
        fmt::format(
            "'{}' is neither a freedom nor an action of coupling '{}'", name.text, at->first),
        guess_before(
            name.text,
            at->second,
            fmt::format("it has {}{}",
                        plain_list(at->second),
                        have_columns ? fmt::format("; columns have a slash: {}/QUANTITY", at->first)
                                     : "")));
  }
}

}  // namespace kinestat
