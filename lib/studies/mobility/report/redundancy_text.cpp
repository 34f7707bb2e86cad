#include <fmt/format.h>

#include "core/text.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/label_kind.hpp"
#include "report/number_format.hpp"
#include "studies/mobility/report/mobility_text.hpp"
#include "studies/mobility/report/mobility_words.hpp"

namespace kinestat {

namespace {

class RedundancyText {
 public:
  explicit RedundancyText(const MobilityAnalysis& analysis)
      : analysis_(analysis), exact_(*analysis.mobility.exact), units_(analysis.description.units) {}

  std::string run() const {
    std::string text = section("space", exact_.spatial, analysis_.in_space);
    if (exact_.planar) {
      text += section("the plane", *exact_.planar, analysis_.mechanism);
    } else if (exact_.minimal.order < exact_.spatial.order && exact_.minimal.net_constraint > 0) {
      text += section(
          fmt::format("order {}", exact_.minimal.order), exact_.minimal, analysis_.mechanism);
    }
    return text + advice();
  }

 private:
  std::string section(const std::string& where,
                      const Redundancies& redundancies,
                      const Mechanism& mechanism) const {
    const int of_model = redundancies.net_constraint - redundancies.borne;
    std::string text = fmt::format("Redundant in {}: {}", where, redundancies.net_constraint);
    if (of_model > 0) {
      text += fmt::format(", {} due to modelling only",
                          redundancies.borne == 0 ? "all" : std::to_string(of_model));
    }
    text +=
        redundancies.borne > 0 && redundancies.constraints.empty() ? ", too many to list\n" : "\n";
    for (std::size_t i = 0; i < redundancies.constraints.size(); ++i) {
      text += constraint(i + 1, redundancies.constraints[i], mechanism);
    }
    return text + "\n";
  }

  // "1. force along z round the circuit of d", then the shares.
  std::string constraint(std::size_t number,
                         const RedundantConstraint& one,
                         const Mechanism& mechanism) const {
    const Topology& topology = mechanism.topology;
    const auto kind = [&](int a) { return kind_of(topology.actions[static_cast<std::size_t>(a)]); };
    std::optional<double> first;
    if (one.axis) {
      first = units_.factor(one.axis->pitch ? QuantityKind::force : QuantityKind::moment);
    }
    std::vector<std::string> shares;
    for (int a = 0; a < topology.action_count(); ++a) {
      if (one.magnitudes[a] != 0.0) {
        first = first.value_or(units_.factor(kind(a)));
        const double share = one.magnitudes[a] * (*first / units_.factor(kind(a)));
        shares.push_back(fmt::format(
            "{} = {} {}", topology.action_name(a), format_short(share), units_.text(kind(a))));
      }
    }
    const std::string name = one.chord ? fmt::format("{} around the circuit of {}",
                                                     constraint_words(analysis_, one),
                                                     topology.coupling(*one.chord).name)
                                       : "through several circuits";
    return fmt::format("  {}. {}\n     {}\n", number, name, fmt::join(shares, ", "));
  }

  std::string advice() const {
    if (exact_.repairs.empty()) {
      return {};
    }
    const Repair& any = exact_.repairs.front();
    std::string text = fmt::format(
        "Advice: each of these removes {}; counted anew, {} and nothing "
        "redundant{}\n",
        any.freed == 1 ? "it" : fmt::format("all {}", any.freed),
        counted(any.after.net_freedom, "freedom"),
        any.after.net_constraint == 0 ? "" : " but in the model");
    for (std::size_t i = 0; i < exact_.repairs.size(); ++i) {
      std::vector<std::string> changes;
      for (const CouplingChange& change : exact_.repairs[i].changes) {
        changes.push_back(change_words(change));
      }
      text += fmt::format("  {}. {}\n", i + 1, fmt::join(changes, "; "));
    }
    return text + "\n";
  }

  std::string change_words(const CouplingChange& change) const {
    const std::string& name = analysis_.mechanism.topology.coupling(change.coupling).name;
    if (change.is_left_out) {
      return fmt::format("leave out {}", name);
    }
    std::vector<std::string> added;
    for (const Twist& twist : change.added) {
      added.push_back(freedom_words(twist));
    }
    return fmt::format(
        "{} {} (+ {})", name, change.to ? word_of(*change.to) : "freer", fmt::join(added, ", "));
  }

  const MobilityAnalysis& analysis_;
  const ExactMobility& exact_;
  const FileUnits& units_;
};

}  // namespace

std::string redundancies_text(const MobilityAnalysis& analysis) {
  return RedundancyText(analysis).run();
}

}  // namespace kinestat
