#include "studies/synthesis/report/plane_text.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "studies/synthesis/positions/path_curvature.hpp"

namespace kinestat {

namespace {

// A limit that is kept to as it is printed.
std::string limit_text(double value, double (*round)(double)) {
  constexpr int kDigits = 6;
  if (!(value > 0.0)) {
    return "0";
  }
  const double last = std::pow(10.0, std::floor(std::log10(value)) + 1 - kDigits);
  return format_short(round(value / last) * last);
}

}  // namespace

std::string limits_text(const LinkageCandidate& candidate, const PlaneText& plane) {
  const auto needed = find_limits_needed(candidate);
  if (!needed) {
    return "";
  }
  constexpr auto kDown = [](double x) { return std::floor(x); };
  constexpr auto kUp = [](double x) { return std::ceil(x); };
  std::vector<std::string> keys;
  if (needed->grashof) {
    keys.push_back(fmt::format("class: {}", word_of(*needed->grashof)));
  }
  if (needed->circuit) {
    keys.push_back(fmt::format("circuit: {}", word_of(*needed->circuit)));
  }
  if (needed->may_stop) {
    keys.push_back("turns_fully: false");
  }
  if (needed->transmission) {
    keys.push_back("transmission_angle: " +
                   limit_text(*needed->transmission / plane.unit_of_angle(), kDown));
  }
  if (needed->full_transmission) {
    keys.push_back("full_transmission_angle: " +
                   limit_text(*needed->full_transmission / plane.unit_of_angle(), kDown));
  }
  if (needed->ratio) {
    keys.push_back("link_ratio: " + limit_text(*needed->ratio, kUp));
  }
  if (needed->size) {
    keys.push_back("size: " + limit_text(*needed->size / plane.unit_of_length(), kUp));
  }
  std::string text = needed->is_any_linkage ? ", but no four-bar, so that it has no class" : "";
  text += needed->is_any_circuit ? ", but without a crank, so that its circuit has no name" : "";
  text += keys.empty() ? "" : fmt::format(" and takes limits: {{{}}}", fmt::join(keys, ", "));
  text += needed->outside ? fmt::format("{} a pivot {} outside its area",
                                        keys.empty() ? ", with" : ", and",
                                        plane.length(*needed->outside))
                          : "";
  return text;
}

std::string left_out_text(const SynthesisTask& task, const LinkageLimits& limits) {
  if (task.left_out.empty()) {
    return "";
  }
  std::vector<std::string> kinds;
  for (const LeftOutLinkages& one : task.left_out) {
    kinds.push_back(fmt::format("{} usable {}", one.usable, word_of(one.type)));
  }
  return fmt::format("excluded by 'linkage: {}': {}; 'linkage: any' lists all\n",
                     word_of(*limits.type),
                     fmt::join(kinds, ", "));
}

namespace {

// Such as ", K' 0.5", if there is a value.
std::string curvature_text(std::string_view symbol,
                           const std::optional<double>& value,
                           double unit) {
  return value ? fmt::format(", {} {}", symbol, format_short(*value * unit)) : "";
}

std::string path_text(const PositionJets& position, const PlaneText& plane) {
  const PathCurvature curvature = find_path_curvature(position, {0.0, 0.0});
  const double unit = plane.unit_of_length();
  const std::string_view parameter = !curvature.k_prime     ? ""
                                     : position.is_directed ? " by the parameter of 'derivatives'"
                                                            : " by the angle in radians";
  const std::string text = curvature_text("K", curvature.k, unit) +
                           curvature_text("K'", curvature.k_prime, unit) +
                           curvature_text("K''", curvature.k_second, unit);
  return text.empty() ? "" : fmt::format("; path of E:{}{}", text.substr(1), parameter);
}

// M or N, infinite where the cubic of stationary curvature falls apart.
std::string diameter_text(double inverse, const PlaneText& plane) {
  return inverse == 0.0 ? "infinite" : plane.length(1.0 / inverse);
}

std::string frame_text(const SpecialFrame& frame, const PlaneText& plane) {
  std::string text = fmt::format("  special frame: x at {}, d {}; inflection circle about {}",
                                 plane.angle(frame.angle),
                                 plane.length(frame.diameter),
                                 plane.point(inflection_circle(frame).centre));
  for (std::size_t k = 3; k < frame.derivatives.size(); ++k) {
    text += fmt::format(
        "{} a_{} b_{} {}", k == 3 ? "\n   " : ";", k, k, plane.point(frame.derivatives[k]));
  }
  if (const auto cubic = find_stationary_curvature(frame)) {
    text += fmt::format("; M {}, N {}",
                        diameter_text(cubic->inverse_m, plane),
                        diameter_text(cubic->inverse_n, plane));
  }
  const auto ball = find_ball_point(frame);
  return text + (ball ? "; Ball's point " + plane.point(*ball) : "") + "\n";
}

std::string why_no_pole(const PositionJets& position) {
  return position.angle[1] == 0.0 ? "no pole, it does not turn"
                                  : "its pole is farther away than can be computed with";
}

}  // namespace

std::string positions_text(const SynthesisTask& task, const PlaneText& plane) {
  std::string text;
  for (std::size_t i = 0; i < task.positions.size(); ++i) {
    const PositionJets& position = task.positions[i];
    if (position.order() < 2) {
      continue;
    }
    const auto pole = find_pole(position);
    text += fmt::format("position {}, {}: {}{}\n",
                        i + 1,
                        form_of(std::span(&position, 1)),
                        pole ? "pole " + plane.point(*pole) : why_no_pole(position),
                        path_text(position, plane));
    if (const auto frame = find_special_frame(position)) {
      text += frame_text(*frame, plane);
    }
  }
  return text;
}

}  // namespace kinestat
