#include "run/inputs.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cases/findings/known_side.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "files/each_file.hpp"
#include "files/load_file.hpp"
#include "kinematics/velocity.hpp"
#include "network/bases.hpp"
#include "statics/action.hpp"
#include "studies/inputs/report/inputs_report.hpp"
#include "studies/inputs/solution_space.hpp"

namespace kinestat {

namespace {

// One side with what the user calls its magnitudes.
struct Side {
  InputSide shown;
  SolutionSpace space;
  int ActuatorTopology::*of_actuator = nullptr;
};

// The magnitude of a name on this side; -1 if there is none.
int find_magnitude(const Side& side, const Topology& topology, const std::string& name) {
  const auto actuator = std::ranges::find(topology.actuators, name, &ActuatorTopology::name);
  if (actuator != topology.actuators.end()) {
    return (*actuator).*side.of_actuator;
  }
  const auto at = std::ranges::find(side.shown.names, name);
  return at == side.shown.names.end() ? -1 : static_cast<int>(at - side.shown.names.begin());
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else if (c != ' ') {
      parts.back() += c;
    }
  }
  return parts;
}

std::vector<Primary> primaries_of(const std::vector<int>& magnitudes) {
  std::vector<Primary> primaries;
  for (const int m : magnitudes) {
    Primary primary;
    primary.index = m;
    primaries.push_back(std::move(primary));
  }
  return primaries;
}

class InputsJob {
 public:
  InputsJob(const std::string& file,
            const Loaded& loaded,
            const InputsChoice& choice,
            Diagnostics& found)
      : choice_(choice),
        found_(found),
        motion_basis_(motion_basis(loaded.mechanism.geometry, loaded.mechanism.kinematic_order)),
        action_basis_(action_basis(loaded.mechanism.geometry, loaded.mechanism.static_order)) {
    analysis_.file = file;
    analysis_.description = loaded.description;
    analysis_.mechanism = loaded.mechanism;
    which_.label = "inputs";
  }

  // Empty iff an error was added.
  std::optional<FileReport> run(const ReportForms& forms) {
    const int errors_before = found_.error_count();
    make_sides();
    check_names(choice_.among, "--among");
    check_names(choice_.required, "--with");
    judge();
    if (found_.error_count() > errors_before) {
      return std::nullopt;
    }
    InputsAnalysis inputs;
    for (Side& side : sides_) {
      side.shown.sets = find_input_sets(side.space.basis, choice_of(side));
      side.shown.evidence = side.space.evidence;
      inputs.sides.push_back(std::move(side.shown));
    }
    inputs.choices = verdicts_;
    inputs.cables = find_cable_tension(analysis_.mechanism);
    return make_inputs_report(analysis_.file, analysis_.description, inputs, forms, found_);
  }

  bool has_refused() const {
    return std::ranges::any_of(verdicts_, [](const ChoiceVerdict& one) { return !one.is_valid; });
  }

 private:
  const Topology& topology() const { return analysis_.mechanism.topology; }

  void make_sides() {
    Side motions{.shown = {.key = "motion", .names = {}, .sets = {}, .evidence = {}},
                 .space = motion_space(analysis_.mechanism, motion_basis_),
                 .of_actuator = &ActuatorTopology::freedom};
    for (int f = 0; f < topology().freedom_count(); ++f) {
      motions.shown.names.push_back(topology().freedom_name(f));
    }
    Side actions{.shown = {.key = "action", .names = {}, .sets = {}, .evidence = {}},
                 .space = action_space(analysis_.mechanism, action_basis_),
                 .of_actuator = &ActuatorTopology::action};
    for (int a = 0; a < topology().action_count(); ++a) {
      actions.shown.names.push_back(topology().action_name(a));
    }
    sides_ = {std::move(motions), std::move(actions)};
  }

  void refuse_name(const std::string& option, const std::string& name) {
    std::vector<std::string> names;
    for (const Side& side : sides_) {
      names.insert(names.end(), side.shown.names.begin(), side.shown.names.end());
    }
    const std::string guess = did_you_mean(name, names);
    found_.error(
        "E0101",
        {},
        fmt::format(
            "{} '{}': there is no such freedom, action or actuator", option, printable(name)),
        guess.empty() ? fmt::format("the file has {}", plain_list(names)) : guess);
  }

  void check_names(const std::vector<std::string>& names, const std::string& option) {
    for (const std::string& name : names) {
      const bool is_known = std::ranges::any_of(
          sides_, [&](const Side& side) { return find_magnitude(side, topology(), name) >= 0; });
      if (!is_known) {
        refuse_name(option, name);
      }
    }
  }

  std::vector<int> magnitudes_of(const Side& side, const std::vector<std::string>& names) const {
    std::vector<int> magnitudes;
    for (const std::string& name : names) {
      const int m = find_magnitude(side, topology(), name);
      if (m >= 0 && std::ranges::find(magnitudes, m) == magnitudes.end()) {
        magnitudes.push_back(m);
      }
    }
    return magnitudes;
  }

  InputChoice choice_of(const Side& side) const {
    InputChoice result{.among = magnitudes_of(side, choice_.among),
                       .required = magnitudes_of(side, choice_.required),
                       .listed = choice_.listed};
    if (choice_.only_actuators) {
      for (const ActuatorTopology& actuator : topology().actuators) {
        result.among.push_back(actuator.*side.of_actuator);
      }
    }
    return result;
  }

  // A set of actuators alone is judged on both sides.
  void judge() {
    for (const std::string& text : choice_.judged) {
      const std::vector<std::string> names = split_at_commas(text);
      bool is_judged = false;
      for (const Side& side : sides_) {
        const bool is_here = std::ranges::all_of(names, [&](const std::string& name) {
          return find_magnitude(side, topology(), name) >= 0;
        });
        if (is_here) {
          is_judged = true;
          verdicts_.push_back(judge(side, names));
        }
      }
      if (!is_judged) {
        refuse_set(text, names);
      }
    }
  }

  void refuse_set(const std::string& text, const std::vector<std::string>& names) {
    const int errors_before = found_.error_count();
    check_names(names, "--judge");
    if (found_.error_count() == errors_before) {
      found_.error("E0101",
                   {},
                   fmt::format("--judge '{}' mixes motions and actions", printable(text)),
                   "each set is of one side: give two of them");
    }
  }

  ChoiceVerdict judge(const Side& side, const std::vector<std::string>& names) const {
    const std::vector<int> magnitudes = magnitudes_of(side, names);
    ChoiceVerdict verdict{.key = side.shown.key,
                          .names = {},
                          .is_valid = false,
                          .conditioning = 0.0,
                          .reason = {},
                          .hint = {}};
    for (const int m : magnitudes) {
      verdict.names.push_back(side.shown.names[static_cast<std::size_t>(m)]);
    }
    if (side.shown.key == "motion") {
      judge_motions(magnitudes, verdict);
    } else {
      judge_actions(magnitudes, verdict);
    }
    if (verdict.is_valid) {
      verdict.conditioning = conditioning_of(side.space.basis, magnitudes);
    }
    return verdict;
  }

  void judge_motions(const std::vector<int>& magnitudes, ChoiceVerdict& verdict) const {
    const KinematicSolution motion =
        solve_velocity(analysis_.mechanism, motion_basis_, primaries_of(magnitudes));
    const KnownSide names = motion_side(judged_file(analysis_), which_);
    explain(motion.check,
            names,
            motion.check.dependences.empty() ? ""
                                             : circuits_text(judged_file(analysis_), motion, names),
            verdict);
  }

  void judge_actions(const std::vector<int>& magnitudes, ChoiceVerdict& verdict) const {
    const StaticSolution action =
        solve_action(analysis_.mechanism, action_basis_, primaries_of(magnitudes), {});
    const KnownSide names = action_side(judged_file(analysis_), which_);
    explain(
        action.check,
        names,
        action.check.dependences.empty() ? "" : cutsets_text(judged_file(analysis_), action, names),
        verdict);
  }

  // A dependent set contains a circuit of the matroid, an incomplete one leaves magnitudes open.
  static void explain(const PrimaryCheck& check,
                      const KnownSide& side,
                      const std::string& relations,
                      ChoiceVerdict& verdict) {
    verdict.is_valid = check.dependences.empty() && check.missing == 0;
    if (!check.dependences.empty()) {
      verdict.reason = relations;
      verdict.hint = removal_text(check, side);
    } else if (check.missing > 0) {
      verdict.reason = fmt::format("{} more needed; it does not determine {}",
                                   check.missing,
                                   plain_list(names_of(check.undetermined, side)));
    }
    if (check.missing > 0) {
      verdict.hint += (verdict.hint.empty() ? "" : ", and ") + completions_text(check, side);
    }
  }

  const InputsChoice& choice_;
  Diagnostics& found_;
  CoordinateBasis motion_basis_;
  CoordinateBasis action_basis_;
  Analysis analysis_;  ///< without solved cases
  Case which_;         ///< knows nothing
  std::vector<Side> sides_;
  std::vector<ChoiceVerdict> verdicts_;
};

}  // namespace

Outcome inputs_files(const std::vector<std::string>& paths,
                     const InputsChoice& choice,
                     const AnalyseOptions& options) {
  const ReportForms forms = stream_forms(options.format, paths.size());
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    SourceFile source;
    Diagnostics found;
    if (const std::optional<Loaded> loaded = load(path, options.load, source, found)) {
      InputsJob job(path, *loaded, choice, found);
      if (const auto report = job.run(forms)) {
        add_to_stream(*report, path, paths, options, outcome);
      }
      if (job.has_refused()) {
        outcome.status = worst(outcome.status, ExitStatus::check_failed);
      }
    }
    add_diagnostics(source, found, options.strictness, outcome);
  });
}

}  // namespace kinestat
