#include "studies/synthesis/synthesis.hpp"

#include <algorithm>
#include <cmath>

#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Links that have a length: those between pivots.
std::vector<double> link_lengths(const Linkage& linkage) {
  std::vector<double> lengths;
  for (const Dyad* dyad : {&linkage.one, &linkage.other}) {
    if (dyad->kind == DyadKind::crank) {
      lengths.push_back(dyad->length);
    }
  }
  if (linkage.one.kind != DyadKind::inverted_slider &&
      linkage.other.kind != DyadKind::inverted_slider) {
    lengths.push_back(std::abs(linkage.one.circle_point - linkage.other.circle_point));
  }
  if (linkage.one.kind != DyadKind::slider && linkage.other.kind != DyadKind::slider) {
    lengths.push_back(std::abs(linkage.one.centre_point - linkage.other.centre_point));
  }
  return lengths;
}

// Which dyad the circuit goes by: of a crank-rocker the crank, otherwise the input; of two kinds of
// dyads the crank.
const DriveVerdict* circuit_verdict(const LinkageCandidate& candidate, std::size_t drive) {
  const auto& [one, other] = candidate.verdicts;
  const bool is_one = candidate.linkage.one.kind == DyadKind::crank;
  if (candidate.lengths) {
    return one.turns_fully == other.turns_fully ? &candidate.verdicts[drive]
                                                : &candidate.verdicts[one.turns_fully ? 0 : 1];
  }
  const bool has_crank = is_one || candidate.linkage.other.kind == DyadKind::crank;
  return has_crank ? &candidate.verdicts[is_one ? 0 : 1] : nullptr;
}

std::optional<LinkageCircuit> circuit_of(const LinkageCandidate& candidate, std::size_t drive) {
  using enum LinkageCircuit;
  const DriveVerdict* by = circuit_verdict(candidate, drive);
  if (by == nullptr || !by->same_circuit) {
    return std::nullopt;
  }
  // At a change point the circuits meet.
  const bool meet = candidate.grashof && candidate.grashof->kind == GrashofClass::change_point;
  if (by->mirror == 0 || meet) {
    return single;
  }
  if (candidate.lengths && !by->turns_fully) {
    return by->mirror > 0 ? left : right;
  }
  // Of a slider and a guide the sides are those of their direction, and a rocking crank counts its
  // angle from the normal to the left of it.
  const bool is_ahead = (by->mirror > 0) == by->turns_fully;
  return is_ahead == !candidate.lengths ? open : crossed;
}

// One of those that are asked for.
template <typename Which>
bool is_asked(std::optional<Which> found, const std::vector<Which>& asked) {
  return asked.empty() || (found && std::ranges::find(asked, *found) != asked.end());
}

// Whether the input takes the linkage through its positions; if so, what the limits have against
// it.
Defects defects_of(const LinkageCandidate& candidate,
                   std::size_t drive,
                   const LinkageLimits& limits) {
  const DriveVerdict& verdict = candidate.verdicts[drive];
  Defects defects;
  if (!verdict.same_circuit) {
    defects.add(Defect::circuit);
  } else if (!verdict.same_branch) {
    defects.add(Defect::branch);
  } else if (verdict.passage == Passage::none) {
    defects.add(Defect::order);
  }
  if (!is_asked(circuit_of(candidate, drive), limits.circuits)) {
    defects.add(Defect::other_circuit);
  }
  if (limits.turns_fully && !verdict.turns_fully) {
    defects.add(Defect::full_turn);
  }
  // Rounding must not decide at the limit itself.
  if (verdict.working_arc &&
      verdict.working_arc->margin() < limits.transmission * (1.0 - kSameValue)) {
    defects.add(Defect::transmission);
  }
  if (verdict.full.margin() < limits.full_transmission * (1.0 - kSameValue)) {
    defects.add(Defect::full_transmission);
  }
  return defects;
}

double margin_of(const DriveVerdict& verdict) {
  return verdict.working_arc ? verdict.working_arc->margin() : 0.0;
}

int rank_of(const Defects& defects) {
  const auto all = static_cast<int>(kDefectCount);
  const int worst = static_cast<int>(defects.worst());
  return defects.are_of_limits() ? (all - static_cast<int>(defects.count())) * all + worst : worst;
}

void choose_drive(LinkageCandidate& candidate, const LinkageLimits& limits) {
  const Defects one = defects_of(candidate, 0, limits);
  if (limits.function) {
    candidate.defects = one;
    return;
  }
  const Defects other = defects_of(candidate, 1, limits);
  const bool takes_other =
      Standing(other, candidate.verdicts[1]).is_better_than({one, candidate.verdicts[0]});
  candidate.best_drive = takes_other ? Drive::other : Drive::one;
  candidate.defects = takes_other ? other : one;
}

void check_areas(const LinkageLimits& limits, LinkageCandidate& candidate) {
  for (const DyadPoint which : {DyadPoint::circle_point, DyadPoint::centre_point}) {
    for (const Dyad* dyad : {&candidate.linkage.one, &candidate.linkage.other}) {
      const double outside = distance_outside(*dyad, which, limits);
      candidate.outside = std::max(candidate.outside, outside);
      if (outside > 0.0) {
        candidate.defects.add(which == DyadPoint::circle_point ? Defect::circle_point
                                                               : Defect::centre_point);
      }
    }
  }
}

bool has_digits(const Dyad& dyad) {
  return dyad.digits >= -std::log10(kUselessLoss);
}

LinkageCandidate judge(const Linkage& linkage,
                       std::span<const PositionJets> positions,
                       const LinkageLimits& limits) {
  LinkageCandidate candidate;
  candidate.linkage = linkage;
  candidate.lengths = lengths_of(linkage);
  if (candidate.lengths) {
    candidate.grashof = classify(*candidate.lengths);
  }
  int sense = 0;
  if (limits.function) {
    candidate.positions = coupler_positions(*limits.function, linkage);
    positions = candidate.positions;
    sense = limits.function->sense();
  } else {
    candidate.cognates = find_cognates(linkage, pose_of(positions[0]), {0.0, 0.0});
  }
  candidate.verdicts = {find_verdict(linkage, Drive::one, positions, sense),
                        find_verdict(linkage, Drive::other, positions)};
  choose_drive(candidate, limits);
  candidate.circuit = circuit_of(candidate, candidate.best_drive == Drive::one ? 0 : 1);
  if (!has_digits(linkage.one) || !has_digits(linkage.other)) {
    candidate.defects.add(Defect::digits);
  }
  const auto grashof = candidate.grashof ? std::optional(candidate.grashof->kind) : std::nullopt;
  if (!is_asked(grashof, limits.classes)) {
    candidate.defects.add(Defect::grashof);
  }
  check_areas(limits, candidate);
  const std::vector<double> lengths = link_lengths(linkage);
  if (!lengths.empty()) {
    candidate.longest = std::ranges::max(lengths);
    candidate.ratio = candidate.longest / std::ranges::min(lengths);
  }
  if (candidate.ratio > limits.ratio * (1.0 + kSameValue)) {
    candidate.defects.add(Defect::ratio);
  }
  if (candidate.longest > limits.size * (1.0 + kSameValue)) {
    candidate.defects.add(Defect::size);
  }
  return candidate;
}

}  // namespace

double distance_outside(const Dyad& dyad, DyadPoint which, const LinkageLimits& limits) {
  const bool is_circle_point = which == DyadPoint::circle_point;
  const std::optional<PlaneArea>& area =
      is_circle_point ? limits.circle_points : limits.centre_points;
  const bool is_infinite =
      dyad.kind == (is_circle_point ? DyadKind::inverted_slider : DyadKind::slider);
  return area && !is_infinite
             ? area->distance(is_circle_point ? dyad.circle_point : dyad.centre_point)
             : 0.0;
}

Standing::Standing(const Defects& defects, const DriveVerdict& verdict)
    : rank(rank_of(defects)), margin(margin_of(verdict)) {}

bool Standing::is_better_than(const Standing& other) const {
  return rank != other.rank ? rank > other.rank : margin > other.margin;
}

const DriveVerdict& LinkageCandidate::best() const {
  return verdicts[best_drive == Drive::one ? 0 : 1];
}

double LinkageCandidate::margin() const {
  return margin_of(best());
}

std::vector<LinkageCandidate> rank_linkages(std::span<const Dyad> dyads,
                                            std::span<const PositionJets> positions,
                                            const LinkageLimits& limits) {
  std::vector<LinkageCandidate> candidates;
  for (std::size_t pair = 0; pair < dyads.size() * dyads.size(); ++pair) {
    const std::size_t i = pair / dyads.size();
    const std::size_t j = pair % dyads.size();
    const Linkage linkage{.one = dyads[i], .other = dyads[j]};
    const bool is_pair = limits.function ? i % 2 == 0 && j == i + 1 : i < j;
    if (is_pair && (!limits.type || linkage.type() == *limits.type)) {
      candidates.push_back(judge(linkage, positions, limits));
      candidates.back().dyads = {i, j};
    }
  }
  std::ranges::stable_sort(candidates, [](const auto& one, const auto& other) {
    return one.standing().is_better_than(other.standing());
  });
  return candidates;
}

}  // namespace kinestat
