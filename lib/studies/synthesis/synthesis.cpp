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

Defect defect_of(const DriveVerdict& verdict, const LinkageLimits& limits) {
  if (!verdict.same_circuit) {
    return Defect::circuit;
  }
  if (!verdict.same_branch) {
    return Defect::branch;
  }
  if (verdict.passage == Passage::none) {
    return Defect::order;
  }
  if (limits.turns_fully && !verdict.turns_fully) {
    return Defect::full_turn;
  }
  // Rounding must not decide at the limit itself.
  if (verdict.working_arc->margin() < limits.transmission * (1.0 - kSameValue)) {
    return Defect::transmission;
  }
  return verdict.full.margin() < limits.full_transmission * (1.0 - kSameValue)
             ? Defect::full_transmission
             : Defect::none;
}

double margin_of(const DriveVerdict& verdict) {
  return verdict.working_arc ? verdict.working_arc->margin() : 0.0;
}

void choose_drive(LinkageCandidate& candidate, const LinkageLimits& limits) {
  const Defect one = defect_of(candidate.verdicts[0], limits);
  if (limits.function) {
    candidate.defect = one;
    return;
  }
  const Defect other = defect_of(candidate.verdicts[1], limits);
  const bool takes_other =
      Standing(other, candidate.verdicts[1]).is_better_than({one, candidate.verdicts[0]});
  candidate.best_drive = takes_other ? Drive::other : Drive::one;
  candidate.defect = takes_other ? other : one;
}

bool has_class(const LinkageCandidate& candidate, const std::vector<GrashofClass>& asked) {
  return asked.empty() ||
         (candidate.grashof && std::ranges::find(asked, candidate.grashof->kind) != asked.end());
}

// The worse of what speaks against a linkage already and this.
void add_defect(Defect defect, LinkageCandidate& candidate) {
  if (candidate.defect == Defect::none || defect < candidate.defect) {
    candidate.defect = defect;
  }
}

void check_areas(const LinkageLimits& limits, LinkageCandidate& candidate) {
  for (const DyadPoint which : {DyadPoint::circle_point, DyadPoint::centre_point}) {
    for (const Dyad* dyad : {&candidate.linkage.one, &candidate.linkage.other}) {
      const double outside = distance_outside(*dyad, which, limits);
      candidate.outside = std::max(candidate.outside, outside);
      if (outside > 0.0) {
        add_defect(which == DyadPoint::circle_point ? Defect::circle_point : Defect::centre_point,
                   candidate);
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
  if (!has_digits(linkage.one) || !has_digits(linkage.other)) {
    candidate.defect = Defect::digits;
  }
  if (!has_class(candidate, limits.classes)) {
    add_defect(Defect::grashof, candidate);
  }
  check_areas(limits, candidate);
  const std::vector<double> lengths = link_lengths(linkage);
  if (!lengths.empty()) {
    candidate.longest = std::ranges::max(lengths);
    candidate.ratio = candidate.longest / std::ranges::min(lengths);
  }
  if (candidate.ratio > limits.ratio * (1.0 + kSameValue)) {
    add_defect(Defect::ratio, candidate);
  }
  if (candidate.longest > limits.size * (1.0 + kSameValue)) {
    add_defect(Defect::size, candidate);
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

std::string_view word_of(Defect defect) {
  switch (defect) {
    case Defect::none:
      return "none";
    case Defect::digits:
      return "digits";
    case Defect::circuit:
      return "circuit";
    case Defect::branch:
      return "branch";
    case Defect::order:
      return "order";
    case Defect::grashof:
      return "class";
    case Defect::full_turn:
      return "turns_fully";
    case Defect::centre_point:
      return "centre_points";
    case Defect::circle_point:
      return "circle_points";
    case Defect::transmission:
      return "transmission_angle";
    case Defect::full_transmission:
      return "full_transmission_angle";
    case Defect::ratio:
      return "link_ratio";
    case Defect::size:
      return "size";
  }
  return "";
}

Standing::Standing(Defect defect, const DriveVerdict& verdict)
    : rank(defect == Defect::none ? static_cast<int>(Defect::size) + 1 : static_cast<int>(defect)),
      margin(margin_of(verdict)) {}

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
