#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "mechanism/check/section_checks.hpp"

namespace kinestat {

namespace {

constexpr NumberRule kPathRatio = {
    .kind = QuantityKind::dimensionless, .range = kNotZero, .allowed = "a ratio other than zero"};

constexpr NumberRule kTransmissionAngle = {
    .kind = QuantityKind::angle,
    .range = kAcuteAngle,
    .allowed = "the least angle allowed, from 0 deg to below 90 deg, for example 30 deg"};

constexpr NumberRule kLinkRatio = {
    .kind = QuantityKind::dimensionless,
    .range = kAtLeastOne,
    .allowed = "the largest ratio of two links allowed, at least 1, for example 12"};

constexpr NumberRule kPointCount = {.kind = QuantityKind::dimensionless,
                                    .range = kPoints,
                                    .allowed = "a whole number from 2 to 1000000"};

constexpr NumberRule kDigitCount = {
    .kind = QuantityKind::dimensionless,
    .range = kDigits,
    .allowed = "a whole number of decimal digits from 17 to 100; without it there are 16"};

class SynthesisCheck {
 public:
  SynthesisCheck(const SectionContext& context, const SynthesisDescription& task)
      : context_(context), task_(task) {}

  void run() {
    for (std::size_t i = 0; i < task_.positions.size(); ++i) {
      check_position(task_.positions[i], fmt::format("position {}", i + 1));
    }
    if (task_.function) {
      check_function(*task_.function);
    } else {
      check_count();
      check_tasks();
    }
    context_.number(
        task_.limits.transmission_angle, kTransmissionAngle, "'transmission_angle' of 'limits'");
    context_.number(task_.limits.full_transmission_angle,
                    kTransmissionAngle,
                    "'full_transmission_angle' of 'limits'");
    context_.number(task_.limits.link_ratio, kLinkRatio, "'link_ratio' of 'limits'");
    context_.number(task_.limits.size, kAboveZeroLength, "'size' of 'limits'");
    check_classes();
    check_area(task_.limits.circle_points, "circle_points");
    check_area(task_.limits.centre_points, "centre_points");
    check_dyads();
    check_limits_of_function();
    for (const SynthesisRange& range : task_.vary) {
      check_range(range);
    }
    context_.number(task_.curve_count, kPointCount, "'count' of 'curves'");
    context_.number(task_.samples, kPointCount, "'samples' of 'vary'");
    check_effective();
    context_.number(task_.digits, kDigitCount, "'digits' of 'synthesis'");
  }

 private:
  void check_position(const PositionDescription& position, const std::string& what) {
    context_.point(position.at);
    for (const Value& angle : position.angles) {
      context_.number(angle, kAnyAngle, "'angle' of " + what);
    }
    context_.point(position.pole);
    for (const PoseDerivative& derivative : position.derivatives) {
      context_.point(derivative.at);
      context_.number(derivative.angle, kAnyAngle, "'angle' of a derivative of " + what);
    }
    if (position.curvature) {
      check_curvature(position, what);
    }
  }

  void check_curvature(const PositionDescription& position, const std::string& what) {
    const CurvatureDescription& curvature = *position.curvature;
    context_.point(curvature.centre);
    context_.point(curvature.free_point);
    context_.number(curvature.m, kPathRatio, "'m' of " + what);
    for (const FreeNumber varied : {FreeNumber::m, FreeNumber::s}) {
      if (curvature.m && is_varied(varied)) {
        has_both("m", varied, curvature.m->where, what);
      }
    }
    for (const FreeNumber varied : {FreeNumber::free_point, FreeNumber::s}) {
      if (curvature.free_point && is_varied(varied)) {
        has_both("free_point", varied, curvature.free_point->where, what);
      }
    }
    const bool needs = !is_varied(FreeNumber::s);
    const bool lacks_point = needs && !curvature.free_point && !is_varied(FreeNumber::free_point);
    const bool lacks_m = needs && !curvature.m && !is_varied(FreeNumber::m);
    if (lacks_point && lacks_m && position_count() == 5) {
      refuse_open(position, what);
      return;
    }
    if (lacks_point) {
      refuse_missing(curvature, what, "free_point", "free_point: [x, y]");
    }
    if (lacks_m) {
      refuse_missing(curvature, what, "m", "m: 0.58");
    }
  }

  // Of what the path of 'at' alone leaves open, its effective freedom is the best to vary.
  void refuse_open(const PositionDescription& position, const std::string& what) {
    const auto at = context_.vector(position.at.coordinates, QuantityKind::length);
    const auto pole = context_.vector(position.pole->coordinates, QuantityKind::length);
    const double unit = context_.description.units.factor(QuantityKind::length);
    context_.found.error(
        "E0303",
        position.curvature->where,
        fmt::format("'curvature' of {} lacks the keys 'free_point' and 'm'", what),
        fmt::format(
            "let what they leave open vary: {}; or add 'free_point: [x, y]' and 'm: 0.58'",
            example_of_ranges(position.order(), at && pole ? (*pole - *at).norm() / unit : 0.0)));
  }

  bool is_varied(FreeNumber which) const {
    return std::ranges::any_of(task_.vary,
                               [&](const SynthesisRange& range) { return range.which == which; });
  }

  // A number that a range would override without a word.
  void has_both(std::string_view key,
                FreeNumber varied,
                SourceRange where,
                const std::string& what) {
    const std::string_view word = word_of(varied);
    context_.found.error(
        "E0302",
        where,
        word == key
            ? fmt::format("'curvature' of {} gives '{}', which 'vary' lets vary", what, key)
            : fmt::format(
                  "'curvature' of {} gives '{}', for which '{}' of 'vary' stands", what, key, word),
        fmt::format(
            "delete '{}' here to try the range, or '{}' of 'vary' to keep the number", key, word));
  }

  void refuse_missing(const CurvatureDescription& curvature,
                      const std::string& what,
                      std::string_view key,
                      std::string_view example) {
    context_.found.error(
        "E0303",
        curvature.where,
        fmt::format("'curvature' of {} lacks the key '{}'", what, key),
        position_count() == 5
            ? fmt::format(
                  "add '{}', or let it vary: vary: {{{}: {{from: …, to: …}}}}", example, key)
            : fmt::format("add '{}'; only tasks of five positions may leave it open", example));
  }

  // Each contact with a position before it counts as a position more.
  void check_count() {
    constexpr int kLeast = 2;
    constexpr int kMost = 5;
    const int count = position_count();
    std::string form;
    for (const PositionDescription& position : task_.positions) {
      form +=
          (form.empty() ? "" : "-") + std::string(static_cast<std::size_t>(position.order()), 'P');
    }
    if (count >= kLeast && count <= kMost) {
      return;
    }
    context_.found.error("E0305",
                         task_.where,
                         fmt::format("the task {} has {}; a dyad takes two to five",
                                     shown(form),
                                     counted(count, "position")),
                         count < kLeast ? "add a position, or its pole"
                                        : "leave out a position, a pole, or an order of contact");
  }

  void check_function(const FunctionDescription& function) {
    const auto& [input, output, where] = function;
    check_frame(function);
    check_input(input);
    for (const Value& angle : output.angles) {
      context_.number(angle, kAnyAngle, "an angle of 'output'");
    }
    if (input.angles.size() != output.angles.size()) {
      context_.found.error("E0305",
                           output.where,
                           fmt::format("'input' has {} and 'output' {}",
                                       counted(input.angles.size(), "angle"),
                                       output.angles.size()),
                           "write as many: one of each for every precision point");
    }
    check_given(function);
    if (task_.linkage != LinkageKind::four_bar && task_.linkage != LinkageKind::any) {
      context_.found.error("E0302",
                           where,
                           "'function' is generated by a four-bar, but 'linkage' requests another",
                           "write linkage: four_bar, or leave it out");
    }
  }

  void check_frame(const FunctionDescription& function) {
    const PointDescription& input = function.input.centre_point;
    const PointDescription& output = function.output.centre_point;
    const auto one = context_.vector(input.coordinates, QuantityKind::length);
    const auto other = context_.vector(output.coordinates, QuantityKind::length);
    if (one && other && *one == *other) {
      context_.found.error("E0305",
                           output.where,
                           "'input' and 'output' have the same 'centre_point'",
                           "write two fixed pivots: the frame lies between them");
    }
  }

  // A crank comes to a place once a turn, and passes places in their order.
  void check_input(const FunctionLink& input) {
    std::vector<double> angles;
    for (const Value& angle : input.angles) {
      const auto number = context_.number(angle, kAnyAngle, "an angle of 'input'");
      if (number) {
        angles.push_back(*number);
      }
    }
    if (angles.size() < input.angles.size()) {
      return;
    }
    const bool rises = std::ranges::adjacent_find(angles, std::greater_equal<>()) == angles.end();
    const bool falls = std::ranges::adjacent_find(angles, std::less_equal<>()) == angles.end();
    if (!(rises || falls) || std::abs(angles.back() - angles.front()) >= 2.0 * std::numbers::pi) {
      context_.found.error("E0305",
                           input.where,
                           "the angles of 'input' neither rise nor fall by less than a full turn",
                           "write them in the order in which the input passes them");
    }
  }

  // As of a dyad, see check_dyads.
  void check_given(const FunctionDescription& function) {
    const auto& one = function.input.circle_point;
    const auto& other = function.output.circle_point;
    context_.point(one);
    context_.point(other);
    const int count = position_count();
    if (count > 2 && count < 5 && one && other) {
      context_.found.error(
          "E0302",
          other->where,
          fmt::format(
              "'input' and 'output' give 'circle_point', and {} precision points leave only "
              "one of them free",
              count),
          "keep one: the other follows from it");
    }
    if (count >= 5 && (one || other)) {
      context_.found.error("E0305",
                           (one ? one : other)->where,
                           "five precision points leave no 'circle_point' free",
                           "delete it; 'circle_points' of 'limits' says where pivots may lie");
    }
  }

  // Its fixed pivots are given.
  void check_limits_of_function() {
    if (task_.function && task_.limits.centre_points) {
      context_.found.error("E0302",
                           task_.limits.centre_points->where,
                           "'function' gives the fixed pivots, which 'centre_points' of 'limits' "
                           "would limit",
                           "delete it; 'circle_points' says where the moving pivots may lie");
    }
  }

  // The lists of angles multiply; the place is the list that makes too many tasks.
  void check_tasks() {
    constexpr double kMostTasks = 1000.0;
    double count = 1.0;
    SourceRange where;
    for (const PositionDescription& position : task_.positions) {
      const bool was_right = count <= kMostTasks;
      count *= static_cast<double>(position.angles.size());
      where = was_right ? position.angles.front().where : where;
    }
    if (count > kMostTasks) {
      context_.found.error(
          "E0305",
          where,
          fmt::format(
              "the lists of angles make {:.15g} tasks; at most {} can be run", count, kMostTasks),
          "list fewer angles, or share them among several files");
    }
  }

  static std::string shown(const std::string& form) {
    constexpr std::size_t kLongest = 20;
    return form.size() <= kLongest ? form : form.substr(0, kLongest) + "…";
  }

  // Only a four-bar has one.
  void check_classes() {
    if (task_.limits.classes.empty() || task_.linkage == LinkageKind::four_bar ||
        task_.linkage == LinkageKind::any) {
      return;
    }
    context_.found.error(
        "E0302",
        task_.where,
        "'class' of 'limits' is that of a four-bar, but 'linkage' requests another",
        "delete 'class', or write linkage: four_bar");
  }

  // A rectangle, or a polygon, that no point can lie in is a mistake.
  void check_area(const std::optional<AreaDescription>& area, std::string_view key) {
    if (!area) {
      return;
    }
    std::vector<Vec3> corners;
    for (const PointDescription& corner : area->corners) {
      if (const auto point = context_.vector(corner.coordinates, QuantityKind::length)) {
        corners.push_back(*point);
      }
    }
    const bool is_whole = corners.size() == area->corners.size();
    if (is_whole &&
        std::ranges::all_of(corners, [&](const Vec3& one) { return one == corners.front(); })) {
      context_.found.error("E0321",
                           area->where,
                           fmt::format("the area of '{}' is a single point", key),
                           "write two opposite corners of a rectangle, or those of a polygon");
    }
  }

  // What belongs to a given point: a line with two positions, one point with three and four.
  void check_dyads() {
    const int count = position_count();
    for (std::size_t i = 0; i < task_.dyads.size(); ++i) {
      const DyadDescription& dyad = task_.dyads[i];
      context_.point(dyad.circle_point);
      context_.point(dyad.centre_point);
      if (count > 2 && count < 5 && dyad.circle_point && dyad.centre_point) {
        context_.found.error(
            "E0302",
            dyad.where,
            fmt::format("dyad {} gives both points, and {} positions leave only one of them free",
                        i + 1,
                        count),
            "keep one: the other follows from it");
      }
    }
    if (!task_.dyads.empty() && count >= 5) {
      context_.found.error("E0305",
                           task_.dyads.front().where,
                           "five positions have dyads of their own, and none can be given",
                           "delete 'dyads'; 'centre_points' and 'circle_points' of 'limits' say "
                           "where pivots may lie");
    }
  }

  int position_count() const {
    if (task_.function) {
      return static_cast<int>(task_.function->input.angles.size());
    }
    int count = 0;
    for (const PositionDescription& position : task_.positions) {
      count += position.order();
    }
    return count;
  }

  void check_range(const SynthesisRange& range) {
    if (chooses_dyads(range.which)) {
      check_choice(range);
      return;
    }
    context_.components(range.from, kind_of(range.which));
    context_.components(range.to, kind_of(range.which));
    const bool has_curvature = std::ranges::any_of(
        task_.positions, [](const PositionDescription& one) { return one.curvature.has_value(); });
    if (!has_curvature) {
      context_.found.error(
          "E0313",
          range.name_where,
          fmt::format("'vary' names '{}', but no position has 'curvature'", word_of(range.which)),
          "remove it, or add 'curvature' to a position");
    }
  }

  void check_choice(const SynthesisRange& range) {
    const bool is_moving = range.which == FreeNumber::circle_points;
    const std::string_view points = is_moving ? "circle points" : "centre points";
    const std::optional<Vec3> from = context_.vector(range.from, QuantityKind::length);
    const std::optional<Vec3> to = context_.vector(range.to, QuantityKind::length);
    if (from && to && *from == *to) {
      context_.found.error("E0321",
                           range.name_where,
                           fmt::format("the range of the {} is a single point", points),
                           "write two opposite corners of the area in which they may lie");
    }
    if (task_.function && !is_moving) {
      context_.found.error("E0302",
                           range.name_where,
                           "'function' gives the fixed pivots, so that 'centre_points' cannot vary",
                           "write circle_points: the pivot of the input on the coupler");
    }
    const int count = position_count();
    if (count != 3 && count != 4) {
      context_.found.error(
          "E0305",
          range.name_where,
          fmt::format("{} are free with three and four positions, and this has {}", points, count),
          task_.function ? "give three or four angles of each link"
          : count < 3    ? "add a position, its pole or its curvature"
                         : "five positions have their own; let 'm', 'free_point' or 's' vary");
    }
    const auto& function = task_.function;
    if (function && (function->input.circle_point || function->output.circle_point)) {
      context_.found.error("E0302",
                           range.name_where,
                           "'circle_point' of a link is given, and 'circle_points' has nothing to "
                           "choose",
                           "delete one of the two");
    }
    if (task_.dyads.size() == 2) {
      context_.found.error(
          "E0302",
          range.name_where,
          fmt::format("both dyads are given, and '{}' has nothing to choose", word_of(range.which)),
          "delete it, or one of 'dyads'");
    }
  }

  // s, tau and tau_2 stand for free point and m together, one for each order.
  void check_effective() {
    using enum FreeNumber;
    const bool is_stationary = std::ranges::any_of(
        task_.positions, [](const PositionDescription& one) { return one.stationary; });
    const bool is_burmester = std::ranges::any_of(
        task_.positions, [](const PositionDescription& one) { return one.burmester; });
    check_needed(tau, s, is_stationary, "stationary");
    check_needed(tau_2, tau, is_burmester, "burmester");
  }

  // An order that a position has and one that 'vary' has belong together.
  void check_needed(FreeNumber which, FreeNumber before, bool has_order, std::string_view order) {
    if (is_varied(before) && has_order && !is_varied(which)) {
      context_.found.error("E0303",
                           place_of(before),
                           fmt::format("'vary' names '{}' and needs '{}' for '{}: true'",
                                       word_of(before),
                                       word_of(which),
                                       order),
                           fmt::format("add {}: {{from: -1, to: 1}}", word_of(which)));
    }
    if (is_varied(which) && !(is_varied(before) && has_order)) {
      context_.found.error("E0313",
                           place_of(which),
                           fmt::format("'vary' names '{}', which needs '{}' and '{}: true'",
                                       word_of(which),
                                       word_of(before),
                                       order),
                           "remove it, or add what it needs");
    }
  }

  SourceRange place_of(FreeNumber which) const {
    return std::ranges::find(task_.vary, which, &SynthesisRange::which)->name_where;
  }

  const SectionContext& context_;
  const SynthesisDescription& task_;
};

}  // namespace

void check_synthesis(const SectionContext& context) {
  if (!context.description.synthesis) {
    return;
  }
  if (context.description.synthesis->transmission) {
    check_transmission(context, *context.description.synthesis->transmission);
  } else {
    SynthesisCheck(context, *context.description.synthesis).run();
  }
}

}  // namespace kinestat
