#include "studies/synthesis/report/limits_text.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

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

std::string limits_text(const LinkageCandidate& candidate,
                        const LinkageLimits& limits,
                        const PlaneText& plane) {
  const auto needed = find_limits_needed(candidate, limits);
  if (!needed) {
    return "";
  }
  constexpr auto kDown = [](double x) { return std::floor(x); };
  constexpr auto kUp = [](double x) { return std::ceil(x); };
  std::vector<std::string> keys;
  if (needed->transmission) {
    keys.push_back("transmission_angle: " +
                   limit_text(*needed->transmission / plane.unit_of_angle(), kDown));
  }
  if (needed->ratio) {
    keys.push_back("link_ratio: " + limit_text(*needed->ratio, kUp));
  }
  if (needed->size) {
    keys.push_back("size: " + limit_text(*needed->size / plane.unit_of_length(), kUp));
  }
  return fmt::format(" and takes limits: {{{}}}", fmt::join(keys, ", "));
}

std::string left_out_text(const SynthesisTask& task, const LinkageLimits& limits) {
  if (task.left_out.empty()) {
    return "";
  }
  std::vector<std::string> kinds;
  for (const LeftOutLinkages& one : task.left_out) {
    kinds.push_back(fmt::format("{} usable {}", one.usable, word_of(one.type)));
  }
  return fmt::format("left out by 'linkage: {}': {}; 'linkage: any' lists all\n",
                     word_of(*limits.type),
                     fmt::join(kinds, ", "));
}

}  // namespace kinestat
