#include "mechanism/internal/synthesis_check.hpp"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

namespace kinestat {

namespace {

constexpr NumberRule kPathRatio = {.kind = QuantityKind::dimensionless,
                                   .accepts = [](double x) { return x != 0.0; },
                                   .allowed = "a ratio other than zero"};

constexpr NumberRule kAnyNumber = {.kind = QuantityKind::dimensionless,
                                   .accepts = [](double) { return true; },
                                   .allowed = "a number"};

constexpr NumberRule kTransmissionAngle = {
    .kind = QuantityKind::angle,
    .accepts = [](double x) { return x >= 0.0 && x < std::numbers::pi / 2; },
    .allowed = "the least angle allowed, from 0 deg to below 90 deg, for example 30 deg"};

constexpr NumberRule kLinkRatio = {
    .kind = QuantityKind::dimensionless,
    .accepts = [](double x) { return x >= 1.0; },
    .allowed = "the largest ratio of two links allowed, at least 1, for example 12"};

constexpr NumberRule kCurveCount = {
    .kind = QuantityKind::dimensionless,
    .accepts = [](double x) { return is_whole(x) && x >= 2.0 && x <= 1'000'000.0; },
    .allowed = "a whole number from 2 to 1000000"};

class SynthesisCheck {
 public:
  SynthesisCheck(const SectionContext& context, const SynthesisDescription& task)
      : context_(context), task_(task) {}

  void run() {
    for (std::size_t i = 0; i < task_.positions.size(); ++i) {
      check_position(task_.positions[i], fmt::format("position {}", i + 1));
    }
    check_count();
    context_.number(
        task_.limits.transmission_angle, kTransmissionAngle, "'transmission_angle' of 'limits'");
    context_.number(task_.limits.link_ratio, kLinkRatio, "'link_ratio' of 'limits'");
    context_.number(task_.limits.size, kAboveZeroLength, "'size' of 'limits'");
    for (const SynthesisRange& range : task_.vary) {
      check_range(range);
    }
    context_.number(task_.curve_count, kCurveCount, "'count' of 'curves'");
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
      context_.number(derivative.angle, kAnyNumber, "'angle' of a derivative of " + what);
    }
    if (position.curvature) {
      check_curvature(*position.curvature, what);
    }
  }

  void check_curvature(const CurvatureDescription& curvature, const std::string& what) {
    context_.point(curvature.centre);
    context_.point(curvature.free_point);
    context_.number(curvature.m, kPathRatio, "'m' of " + what);
    if (!curvature.free_point && !is_varied("free_point")) {
      lacks(curvature, what, "free_point", "free_point: [x, y]");
    }
    if (!curvature.m && !is_varied("m")) {
      lacks(curvature, what, "m", "m: 0.58");
    }
  }

  bool is_varied(std::string_view name) const {
    return std::ranges::any_of(
        task_.vary, [&](const SynthesisRange& range) { return range.name.text == name; });
  }

  void lacks(const CurvatureDescription& curvature,
             const std::string& what,
             std::string_view key,
             std::string_view example) {
    context_.found.error(
        "E0303",
        curvature.where,
        fmt::format("'curvature' of {} lacks the key '{}'", what, key),
        fmt::format("add '{}', or let it vary: vary: {{{}: {{from: …, to: …}}}}", example, key));
  }

  // Each contact with a position before it counts as a position more.
  void check_count() {
    constexpr int kLeast = 2;
    constexpr int kMost = 5;
    int count = 0;
    std::string form;
    for (const PositionDescription& position : task_.positions) {
      count += position.order();
      form +=
          (form.empty() ? "" : "-") + std::string(static_cast<std::size_t>(position.order()), 'P');
    }
    if (count >= kLeast && count <= kMost) {
      return;
    }
    context_.found.error("E0305",
                         task_.where,
                         fmt::format("the task {} has {} position{}; a dyad takes two to five",
                                     shown(form),
                                     count,
                                     count == 1 ? "" : "s"),
                         count < kLeast ? "add a position, or its pole"
                                        : "leave out a position, a pole, or an order of contact");
  }

  static std::string shown(const std::string& form) {
    constexpr std::size_t kLongest = 20;
    return form.size() <= kLongest ? form : form.substr(0, kLongest) + "…";
  }

  void check_range(const SynthesisRange& range) {
    const bool is_point = range.name.text == "free_point";
    const QuantityKind kind = is_point ? QuantityKind::length : QuantityKind::dimensionless;
    context_.components(range.from, kind);
    context_.components(range.to, kind);
    const bool has_curvature = std::ranges::any_of(
        task_.positions, [](const PositionDescription& one) { return one.curvature.has_value(); });
    if (!has_curvature) {
      context_.found.error(
          "E0313",
          range.name.where,
          fmt::format("'vary' names '{}', but no position has 'curvature'", range.name.text),
          "remove it, or add 'curvature' to a position");
    }
  }

  const SectionContext& context_;
  const SynthesisDescription& task_;
};

}  // namespace

void check_synthesis(const SectionContext& context) {
  if (context.description.synthesis) {
    SynthesisCheck(context, *context.description.synthesis).run();
  }
}

}  // namespace kinestat
