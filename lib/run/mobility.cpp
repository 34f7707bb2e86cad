#include "run/mobility.hpp"

#include <optional>
#include <utility>

#include "cases/exact_input_cases.hpp"
#include "cases/findings/certainty_findings.hpp"
#include "files/each_file.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/bind/bind_counted.hpp"
#include "studies/motion/finite_mobility.hpp"

namespace kinestat {

namespace {

void count_without_geometry(MobilityAnalysis& analysis) {
  Mobility& mobility = analysis.mobility;
  mobility.spatial = count_by_grubler(analysis.in_space.topology, analysis.in_space.topology, 6);
  if (analysis.mechanism.space == Space::planar) {
    mobility.planar = count_by_grubler(analysis.mechanism.topology, analysis.in_space.topology, 3);
  }
  if (knows_directions(analysis.description)) {
    mobility.reshetov = find_reshetov_table(analysis.in_space);
  }
}

// And counts what is known of the ranks as typed.
void add_certainty(const AccuracyRequest& accuracy,
                   MobilityAnalysis& analysis,
                   Diagnostics& found) {
  if (accuracy.accuracy != Accuracy::fast) {
    Certainty certainty;
    ExactInputCases exact_input(analysis.description, analysis.mechanism, accuracy);
    exact_input.find_ranks(true, certainty);
    exact_input.count_exact_input(certainty, analysis.mobility.exact->counts);
    add_rank_findings(certainty, found);
  }
}

// Empty where a coupling has no finite law.
std::optional<FiniteMobility> try_motions(const MobilityAnalysis& analysis) {
  const std::vector<DrawnCoupling> drawn =
      bind_drawn_couplings(analysis.description, analysis.mechanism);
  const MotionNetwork network = make_motion_network(analysis.mechanism, drawn, {});
  if (!network.is_movable()) {
    return std::nullopt;
  }
  FiniteMobility finite =
      find_finite_mobility(network, analysis.mechanism, analysis.mobility.exact->motions.motions);
  return finite.is_known ? std::optional(std::move(finite)) : std::nullopt;
}

}  // namespace

std::optional<MobilityAnalysis> find_mobility(const std::string& path,
                                              MechanismDescription description,
                                              const AccuracyRequest& accuracy,
                                              Diagnostics& found) {
  MobilityAnalysis analysis;
  const bool has_places = !can_only_be_counted(description);
  if (has_places) {
    std::optional<Mechanism> mechanism = bind(description, found);
    std::optional<Mechanism> in_space =
        mechanism ? bind_in_space(description, found) : std::nullopt;
    if (!in_space) {
      if (!found.has_errors()) {
        refuse_without_mechanism(description, found);
      }
      return std::nullopt;
    }
    check_exact_input(description, *mechanism, accuracy, found);
    if (found.has_errors()) {
      return std::nullopt;
    }
    analysis.mechanism = *std::move(mechanism);
    analysis.in_space = *std::move(in_space);
  } else {
    std::optional<CountedMechanism> counted = bind_counted(description, found);
    if (!counted) {
      return std::nullopt;
    }
    analysis.mechanism = std::move(counted->mechanism);
    analysis.in_space = std::move(counted->in_space);
  }
  analysis.file = path;
  analysis.description = std::move(description);
  count_without_geometry(analysis);
  if (has_places) {
    analysis.mobility.exact = find_exact_mobility(analysis.mechanism, analysis.in_space);
    analysis.finite = try_motions(analysis);
    add_certainty(accuracy, analysis, found);
  }
  return analysis;
}

Outcome mobility_of_files(const std::vector<std::string>& paths, const AnalyseOptions& options) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    auto description = load_description(file.path, options.load, file.source, file.found);
    const auto analysis =
        description
            ? find_mobility(file.path, *std::move(description), options.accuracy, file.found)
            : std::nullopt;
    return analysis ? std::optional(make_mobility_report(*analysis, file.forms, file.found))
                    : std::nullopt;
  });
}

}  // namespace kinestat
