#include "studies/synthesis/report/linkage_text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/spelling.hpp"
#include "core/utf8.hpp"
#include "studies/synthesis/report/plane_text.hpp"

namespace kinestat {

namespace {

std::string_view phrase_of(Degeneracy reason) {
  switch (reason) {
    case Degeneracy::none:
      return "";
    case Degeneracy::translation:
      return "no dyads: the plane does not turn from position to position, and its places lie on "
             "no circle and no line";
    case Degeneracy::parallelogram:
      return "a family of dyads: the plane moves along a circle and does not turn, so that every "
             "point has a crank of the same length and direction";
    case Degeneracy::straight_translation:
      return "a family of dyads: the plane moves along a line and does not turn, so that every "
             "point is that of a slider, and none that of a crank";
    case Degeneracy::repeated_position:
      return "a family of dyads: a position is there twice, so that conditions are missing";
    case Degeneracy::dependent:
      return "a family of dyads: the conditions of the positions follow from each other";
    case Degeneracy::straight_paths:
      return "a family of dyads: a whole circle of points moves on straight lines";
    case Degeneracy::sliding_lines:
      return "a family of dyads: a whole pencil of lines slides on fixed points";
    case Degeneracy::shared_line:
    case Degeneracy::shared_conic:
      return "a family of dyads: a whole curve of points stays on circles";
  }
  return "";
}

// Two positions that are the same pose.
std::optional<std::pair<std::size_t, std::size_t>> find_same(
    std::span<const PositionJets> positions) {
  for (std::size_t pair = 0; pair < positions.size() * positions.size(); ++pair) {
    const std::size_t i = pair / positions.size();
    const std::size_t j = pair % positions.size();
    if (i < j && is_same_pose(positions[i], positions[j])) {
      return std::pair(i, j);
    }
  }
  return std::nullopt;
}

// What positions leave open of which some are there twice.
std::string_view phrase_of_rest(std::span<const PositionJets> positions) {
  int left = position_count(positions);
  for (std::size_t j = 0; j < positions.size(); ++j) {
    const bool is_there = std::ranges::any_of(positions.first(j), [&](const PositionJets& one) {
      return is_same_pose(one, positions[j]);
    });
    left -= is_there ? 1 : 0;
  }
  switch (left) {
    case 1:
      return "any point may have any centre";
    case 2:
      return "any point is a circle point, with its centres on a line";
    case 3:
      return "any point is a circle point";
    default:
      return "a curve of circle points is left";
  }
}

void add_dyad(const Dyad& dyad, std::size_t index, const PlaneText& plane, Table& table) {
  std::string kind = dyad.multiplicity > 1 ? " double" : "";
  std::string length_text = plane.length(dyad.length);
  if (dyad.kind != DyadKind::crank) {
    kind += dyad.kind == DyadKind::slider ? " slider" : " inverted slider";
    length_text = fmt::format(
        "along ({}, {})", format_short(dyad.direction.real()), format_short(dyad.direction.imag()));
  }
  table.add({fmt::format("{}{}", index, kind),
             plane.point(dyad.circle_point),
             plane.point(dyad.centre_point),
             length_text,
             fmt::format("{:.0f}", dyad.digits)});
}

// Sliders that stand for very long cranks.
std::string straight_text(std::span<const Dyad> dyads, const PlaneText& plane) {
  std::string text;
  for (std::size_t i = 0; i < dyads.size(); ++i) {
    if (dyads[i].crank_length > 0.0) {
      text += fmt::format(
          "dyad {} slides within the decimals of the positions, which miss it by {}; as written "
          "they have a crank of length {}\n",
          i,
          plane.length(dyads[i].deviation),
          plane.length(dyads[i].crank_length));
    }
  }
  return text;
}

// What would be a crank if the places of its circle point were as far from its centre.
std::string nearest_text(const Dyad& dyad, const SynthesisTask& task, const PlaneText& plane) {
  if (dyad.kind != DyadKind::crank) {
    return "";
  }
  std::vector<double> distances;
  for (const PositionJets& position : task.positions) {
    distances.push_back(std::abs(pose_of(position).place(dyad.circle_point) - dyad.centre_point));
  }
  const auto [least, most] = std::ranges::minmax(distances);
  return fmt::format("nearest: circle point {}, centre {}, whose distance goes from {} to {}\n",
                     plane.point(dyad.circle_point),
                     plane.point(dyad.centre_point),
                     plane.length(least),
                     plane.length(most));
}

std::string range_text(const TransmissionRange& range, const PlaneText& plane) {
  return fmt::format("{} to {}", plane.angle(range.least), plane.angle(range.most));
}

Table verdict_table(const SynthesisTask& task, const PlaneText& plane) {
  Table table({"linkage",
               "dyads",
               "drive",
               "verdict",
               "margin",
               "full turn",
               "link ratio",
               "class",
               "circuit"});
  for (std::size_t i = 0; i < task.linkages.size(); ++i) {
    const LinkageCandidate& candidate = task.linkages[i];
    const DriveVerdict& best = candidate.best();
    const std::size_t drive = candidate.best_drive == Drive::one ? 0 : 1;
    table.add({fmt::format("{} {}", i, hyphenated(word_of(candidate.linkage.type()))),
               fmt::format("{} {}", candidate.dyads[0], candidate.dyads[1]),
               fmt::format("{}", candidate.dyads[drive]),
               phrase_of(candidate.defects),
               best.working_arc ? plane.angle(candidate.margin()) : "-",
               best.turns_fully ? "yes" : "no",
               PlaneText::shown(candidate.ratio),
               candidate.grashof ? hyphenated(word_of(candidate.grashof->kind)) : "",
               candidate.circuit ? std::string(word_of(*candidate.circuit)) : ""});
  }
  return table;
}

// The link of a dyad: the length of a crank, or what it is.
std::string link_text(const Dyad& dyad, const PlaneText& plane) {
  switch (dyad.kind) {
    case DyadKind::crank:
      return plane.length(dyad.length);
    case DyadKind::slider:
      return "slider";
    case DyadKind::inverted_slider:
      return "guide";
  }
  return "";
}

// Between two points, unless one of them lies at infinity.
std::string distance_text(bool is_finite,
                          const Point& from,
                          const Point& to,
                          const PlaneText& plane) {
  return is_finite ? plane.length(std::abs(to - from)) : "";
}

// Links in the order of the dyads, and the transmission angle with the drive above.
Table link_table(const SynthesisTask& task, const PlaneText& plane) {
  Table table({"linkage",
               "ground",
               "first",
               "coupler",
               "second",
               "transmission angle",
               "over its whole range"});
  for (std::size_t i = 0; i < task.linkages.size(); ++i) {
    const Dyad& one = task.linkages[i].linkage.one;
    const Dyad& other = task.linkages[i].linkage.other;
    const DriveVerdict& best = task.linkages[i].best();
    const auto has_none = [&](DyadKind kind) { return one.kind != kind && other.kind != kind; };
    table.add(
        {fmt::format("{}", i),
         distance_text(has_none(DyadKind::slider), one.centre_point, other.centre_point, plane),
         link_text(one, plane),
         distance_text(
             has_none(DyadKind::inverted_slider), one.circle_point, other.circle_point, plane),
         link_text(other, plane),
         best.working_arc ? range_text(*best.working_arc, plane) : "-",
         range_text(best.full, plane)});
  }
  return table;
}

TextBlocks cognates_blocks(const SynthesisTask& task, const PlaneText& plane) {
  Table table({"cognates of", "centre of dyad", "third centre", "pivot on it", "other pivot"});
  for (std::size_t i = 0; i < task.linkages.size(); ++i) {
    const LinkageCandidate& candidate = task.linkages[i];
    const bool is_shown = i == 0 || candidate.is_usable();
    for (std::size_t j = 0; is_shown && candidate.cognates && j < 2; ++j) {
      const FourBarPlaces& one = candidate.cognates->linkages[j];
      table.add({fmt::format("{}", i),
                 fmt::format("{}", candidate.dyads[j]),
                 plane.point(one.fixed[1]),
                 plane.point(one.moving[1]),
                 plane.point(one.moving[0])});
    }
  }
  if (table.is_empty()) {
    return {};
  }
  TextBlocks blocks("\n");
  return blocks += TextBlocks(std::move(table), "");
}

std::string files_text(const SynthesisTask& task) {
  std::string text;
  for (const std::string& file : task.files) {
    text += file.empty() ? "" : fmt::format("{}: written\n", printable(file));
  }
  const bool is_asked = !task.files.empty();
  text += is_asked && text.empty() ? "no file is written; --all-linkages writes these too\n" : "";
  return is_asked ? "\n" + text : text;
}

}  // namespace

std::string_view phrase_of(Defect defect) {
  switch (defect) {
    case Defect::none:
      return "usable";
    case Defect::digits:
      return "no digits left";
    case Defect::circuit:
      return "circuit defect";
    case Defect::branch:
      return "branch defect";
    case Defect::order:
      return "order defect";
    case Defect::grashof:
      return "other class";
    case Defect::other_circuit:
      return "other circuit";
    case Defect::full_turn:
      return "drive does not turn fully";
    case Defect::centre_point:
      return "centre point outside";
    case Defect::circle_point:
      return "circle point outside";
    case Defect::transmission:
      return "transmission angle too small";
    case Defect::full_transmission:
      return "transmission angle too small elsewhere";
    case Defect::ratio:
      return "link ratio too large";
    case Defect::size:
      return "linkage too large";
  }
  return "";
}

std::string phrase_of(const Defects& defects) {
  if (!defects.are_of_limits() || defects.is_empty()) {
    return std::string(phrase_of(defects.worst()));
  }
  std::vector<std::string_view> phrases;
  for (std::size_t i = 1; i < kDefectCount; ++i) {
    if (defects.has(static_cast<Defect>(i))) {
      phrases.push_back(phrase_of(static_cast<Defect>(i)));
    }
  }
  return fmt::format("{}", fmt::join(phrases, ", "));
}

std::string_view traced_text(const SynthesisAnalysis& analysis) {
  return analysis.limits.function ? "the coupler's pivot on the input link"
                                  : "the origin of the moving frame";
}

std::string family_text(Degeneracy reason, std::span<const PositionJets> positions) {
  const auto same = find_same(positions);
  return same ? fmt::format(
                    "a family of dyads: positions {} and {} are the same, so that conditions are "
                    "missing: {}\n",
                    same->first + 1,
                    same->second + 1,
                    phrase_of_rest(positions))
              : fmt::format("{}\n", phrase_of(reason));
}

TextBlocks dyads_blocks(const SynthesisTask& task, int digits, const PlaneText& plane) {
  const BurmesterSolution& solution = *task.dyads;
  if (solution.status == BurmesterStatus::no_digits) {
    return TextBlocks(
        fmt::format("no dyads: the positions are too close to each other for {} digits\n", digits));
  }
  TextBlocks text;
  const bool is_family = solution.status == BurmesterStatus::family;
  if (is_family) {
    text += family_text(solution.reason, task.positions);
  }
  Table table({"dyad", "circle point", "centre", "length", "digits"});
  for (std::size_t i = 0; i < solution.dyads.size(); ++i) {
    add_dyad(solution.dyads[i], i, plane, table);
  }
  const std::string straight = straight_text(solution.dyads, plane);
  if (table.is_empty()) {
    text += is_family ? "no dyad stands alone\n" : "no real dyad\n";
  } else {
    text += TextBlocks(std::move(table), "");
    text += straight;
  }
  if (solution.imaginary_count > 0) {
    text += fmt::format("{} dyads are not real\n", solution.imaginary_count);
  }
  const bool has_nearest = solution.dyads.empty() && solution.nearest;
  return text += has_nearest ? nearest_text(*solution.nearest, task, plane) : "";
}

TextBlocks linkages_blocks(const SynthesisTask& task,
                           const LinkageLimits& limits,
                           const PlaneText& plane) {
  if (task.dyads->status == BurmesterStatus::no_digits) {
    return {};
  }
  if (task.linkages.empty()) {
    const bool is_family = task.dyads->status == BurmesterStatus::family;
    const std::string text = task.dyads->dyads.size() >= 2
                                 ? "no linkage of the kind that 'linkage' requests\n"
                             : is_family ? "no linkage: that takes two dyads that stand alone\n"
                                         : "no linkage: that takes two real dyads\n";
    return TextBlocks(text + left_out_text(task, limits));
  }
  TextBlocks text("\n");
  text += TextBlocks(verdict_table(task, plane), "");
  const auto has_no_way = [](const LinkageCandidate& one) { return !one.best().working_arc; };
  if (std::ranges::any_of(task.linkages, has_no_way)) {
    text += "-: the drive does not lead the linkage through all positions in their order\n";
  }
  if (!task.linkages.front().is_usable()) {
    text += fmt::format("no linkage is usable; the first one is the nearest{}\n",
                        limits_text(task.linkages.front(), plane));
  }
  text += left_out_text(task, limits) + "\n";
  text += TextBlocks(link_table(task, plane), "");
  text += cognates_blocks(task, plane);
  return text += files_text(task);
}

}  // namespace kinestat
