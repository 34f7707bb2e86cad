#include "studies/synthesis/task/given_dyad_fault.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "studies/synthesis/report/plane_text.hpp"

namespace kinestat {

namespace {

// With so many digits that it is accepted as it is written, also where it is a whole number then.
std::string typed_point(const Point& p, const FileUnits& units) {
  const auto typed = [&](double length) {
    return fmt::format("{:.10g}", units.from_si(QuantityKind::length, length));
  };
  return fmt::format("[{}, {}]", typed(p.real()), typed(p.imag()));
}

std::string line_text(const CompletedDyad& completed, const PlaneText& plane) {
  return fmt::format("the line through {} along ({}, {})",
                     plane.point(*completed.instead),
                     format_short(completed.along.real()),
                     format_short(completed.along.imag()));
}

// A point of the file, or where it belongs.
struct GivenPoint {
  std::string owner;
  DyadPoint kind = DyadPoint::circle_point;
  SourceRange where;
};

// A coupler of a function has circle points of two links.
GivenPoint given_point(DyadPoint which, std::size_t dyad, const SynthesisDescription& task) {
  const bool is_circle_point = which == DyadPoint::circle_point;
  if (task.function) {
    const FunctionLink& link = is_circle_point ? task.function->input : task.function->output;
    return {.owner = is_circle_point ? "'input'" : "'output'",
            .kind = DyadPoint::circle_point,
            .where = link.circle_point ? link.circle_point->where : link.where};
  }
  const DyadDescription& given = task.dyads[dyad];
  const auto& at = is_circle_point ? given.circle_point : given.centre_point;
  return {.owner = fmt::format("dyad {}", dyad + 1),
          .kind = which,
          .where = at ? at->where : given.where};
}

// "circle points"
std::string_view plural_of(DyadPoint which) {
  return which == DyadPoint::circle_point ? "circle points" : "centre points";
}

}  // namespace

void add_fault(const CompletedDyad& completed,
               std::size_t dyad,
               std::span<const PositionJets> positions,
               const MechanismDescription& description,
               Diagnostics& found) {
  const GivenPoint given = given_point(completed.which, dyad, *description.synthesis);
  const SourceRange where = given.where;
  const PlaneText plane(description.units);
  const std::string_view word = word_of(given.kind);
  const std::string what = fmt::format("'{}' of {}", word, given.owner);
  const std::string instead =
      completed.instead ? typed_point(*completed.instead, description.units) : std::string();
  const std::string form = form_of(positions);
  switch (completed.fault) {
    case GivenFault::none:
      break;
    case GivenFault::open:
      found.error(
          "E0305",
          where,
          fmt::format("the positions {} leave open what belongs to {}", form, what),
          "move it: it is a pole of the positions, or these give no dyads that stand alone");
      break;
    case GivenFault::one_alone:
      found.error("E0303",
                  where,
                  fmt::format("{} lacks the key '{}', for which the two positions {} leave {}",
                              given.owner,
                              word,
                              form,
                              line_text(completed, plane)),
                  fmt::format("add '{}: {}', or another point of that line", word, instead));
      break;
    case GivenFault::off_line:
      found.error("E0305",
                  where,
                  fmt::format("{} is not on {}, which the two positions {} leave it",
                              what,
                              line_text(completed, plane),
                              form),
                  fmt::format("write {}: {}, the nearest point of it, {} {} away",
                              word,
                              instead,
                              plane.length(completed.distance),
                              description.units.text(QuantityKind::length)));
      break;
    case GivenFault::off_curve:
      found.error("E0305",
                  where,
                  fmt::format("{} is not on the curve of {} of the positions {}",
                              what,
                              plural_of(given.kind),
                              form),
                  fmt::format("write {}: {}, the nearest point of it, {} {} away",
                              word,
                              instead,
                              plane.length(completed.distance),
                              description.units.text(QuantityKind::length)));
      break;
  }
}

}  // namespace kinestat
