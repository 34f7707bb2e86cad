#include "studies/mobility/report/mobility_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

std::string point_words(const Vec3& point, const InUnits& in) {
  const Vec3 p = in.length(point);
  return fmt::format("({}, {}, {})", format_short(p.x()), format_short(p.y()), format_short(p.z()));
}

std::string number_words(int number) {
  constexpr std::array<const char*, 7> kWords = {
      "no", "one", "two", "three", "four", "five", "six"};
  return number >= 0 && number < static_cast<int>(kWords.size())
             ? kWords[static_cast<std::size_t>(number)]
             : std::to_string(number);
}

std::string freedoms_words(int count) {
  return fmt::format("{} freedom{}", number_words(count), count == 1 ? "" : "s");
}

std::string constraints_words(int count) {
  return fmt::format("{} redundant constraint{}", number_words(count), count == 1 ? "" : "s");
}

// With a capital letter.
std::string sentence(std::string text) {
  text.front() = text.front() >= 'a' && text.front() <= 'z'
                     ? static_cast<char>(text.front() - 'a' + 'A')
                     : text.front();
  return text;
}

// How Grübler's count compares with the counts of the same order.
std::string grubler_remark(const char* where,
                           const GrublerCount& count,
                           const MotionCounts& exact) {
  const std::string geometry = fmt::format(
      "{} and {}", freedoms_words(exact.net_freedom), constraints_words(exact.net_constraint));
  if (exact.net_constraint == 0 && count.mobility == exact.net_freedom) {
    return fmt::format("{} Grübler's count holds: {}.", where, geometry);
  }
  return fmt::format("{} Grübler gives {}; the geometry of this mechanism gives {}: {} - {} = {}.",
                     where,
                     count.mobility,
                     geometry,
                     exact.net_freedom,
                     exact.net_constraint,
                     exact.net_freedom - exact.net_constraint);
}

std::string reshetov_remark(const ReshetovTable& table, const MotionCounts& exact) {
  if (table.mobility == exact.net_freedom && table.redundant == exact.net_constraint) {
    return fmt::format("The Reshetov table agrees with the geometry: {} and {}.",
                       freedoms_words(table.mobility),
                       constraints_words(table.redundant));
  }
  const bool is_oblique = std::ranges::any_of(table.circuits, [](const ReshetovCircuit& circuit) {
    return circuit.oblique_rotations + circuit.oblique_translations > 0;
  });
  return fmt::format(
      "The Reshetov table fails here: it finds {} and {}, because it considers the directions of "
      "freedoms{} but not the positions of their axes; the geometry decides.",
      freedoms_words(table.mobility),
      constraints_words(table.redundant),
      is_oblique ? " along the world axes, to which some are oblique," : "");
}

std::string passive_remark(const MotionSpace& space) {
  const auto passive = static_cast<int>(std::ranges::count_if(
      space.motions, [](const FreeMotion& motion) { return motion.is_passive(); }));
  if (passive == 0) {
    return {};
  }
  const int rest = space.net_freedom - passive;
  if (rest == 0) {
    return fmt::format("{} {} is passive: it moves no other body and no actuator.",
                       passive == 1 ? "The" : "Each of the",
                       freedoms_words(passive));
  }
  return sentence(
      fmt::format("{} of the {} {} passive, moving no other body and no actuator; {} remain{}.",
                  number_words(passive),
                  freedoms_words(space.net_freedom),
                  passive == 1 ? "is" : "are",
                  number_words(rest),
                  rest == 1 ? "s" : ""));
}

std::string model_remark(const Redundancies& spatial) {
  const int of_model = spatial.net_constraint - spatial.borne;
  if (of_model <= 0) {
    return {};
  }
  return fmt::format(
      "Of the {} in space, {} {} to the model: gears count as rolling pairs, which prevent five "
      "motions though teeth bear one force, and clutches and couplings with 'passive' carry "
      "fewer actions than the motions they block. Nothing loads them, and they are not listed.",
      constraints_words(spatial.net_constraint),
      of_model == spatial.net_constraint ? "all" : std::to_string(of_model),
      of_model == 1 ? "belongs" : "belong");
}

}  // namespace

std::string direction_words(const Vec3& direction) {
  for (int i = 0; i < 3; ++i) {
    if (Vec3::Unit(i).cross(direction).norm() <= kParallelAxes) {
      return std::string(direction[i] < 0.0 ? "-" : "") + static_cast<char>('x' + i);
    }
  }
  const auto part = [&](int i) {
    return format_short(std::abs(direction[i]) <= kParallelAxes ? 0.0 : direction[i]);
  };
  return fmt::format("({}, {}, {})", part(0), part(1), part(2));
}

std::string constraint_words(const MobilityAnalysis& analysis, const RedundantConstraint& one) {
  if (!one.axis) {
    return {};
  }
  const InUnits in(analysis.description.units);
  Vec3 direction = one.axis->direction;
  const auto first =
      std::ranges::find_if(direction, [](double x) { return std::abs(x) > kParallelAxes; });
  if (first != direction.end() && *first < 0.0) {
    direction = -direction;
  }
  const std::string along = direction_words(direction);
  if (!one.axis->pitch) {
    return "couple about " + along;
  }
  const std::string force = one.axis->pitch == 0.0
                                ? "force"
                                : fmt::format("wrench of pitch {} {}",
                                              format_short(in.length(*one.axis->pitch)),
                                              in.units().text(QuantityKind::length));
  const Geometry& geometry = analysis.in_space.geometry;
  const Vec3 point = geometry.origin.in_world(*one.axis->point);
  return one.is_line_free
             ? fmt::format("{} along {}", force, along)
             : fmt::format("{} along {} through {}", force, along, point_words(point, in));
}

std::string freedom_words(const Twist& twist) {
  const bool turns = !twist.angular.isZero(0.0);
  return fmt::format("{} {}",
                     turns ? "rotation about" : "translation along",
                     direction_words(turns ? twist.angular : twist.linear));
}

std::vector<std::string> mobility_remarks(const MobilityAnalysis& analysis) {
  const Mobility& mobility = analysis.mobility;
  std::vector<std::string> remarks;
  const auto add = [&](std::string remark) {
    if (!remark.empty()) {
      remarks.push_back(std::move(remark));
    }
  };
  if (!mobility.exact) {
    add("The file gives no places of couplings, so it is only counted: whether constraints are "
        "redundant, and whether it moves in spite of its count, depends on the geometry.");
    return remarks;
  }
  const MobilityCounts& counts = mobility.exact->counts;
  add(grubler_remark("In space", mobility.spatial, counts.spatial.motions));
  if (mobility.planar && counts.planar) {
    add(grubler_remark("In the plane", *mobility.planar, counts.planar->motions));
  }
  if (mobility.reshetov) {
    add(reshetov_remark(*mobility.reshetov, counts.spatial.motions));
  }
  add(model_remark(mobility.exact->spatial));
  add(passive_remark(mobility.exact->motions));
  return remarks;
}

}  // namespace kinestat
