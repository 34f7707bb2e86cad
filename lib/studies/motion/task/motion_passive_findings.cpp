#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "studies/mobility/passive_freedom.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/task/idle_rates.hpp"
#include "studies/motion/task/motion_findings.hpp"

namespace kinestat {

namespace {

class PassiveFindings {
 public:
  PassiveFindings(const FoundMotion& motion, const Mechanism& mechanism)
      : plan_(motion.plan),
        report_(motion.plan.report),
        trace_(motion.plan.trace),
        mechanism_(mechanism),
        has_position_(
            freedom_positions(motion.network, mechanism, motion.solution.configuration_at(0))) {}

  bool shows_position(const PassiveFreedom& one) const {
    return shows_body(one) || shows(one, true) || shows_load(one);
  }

  // By the actions that the direction of a load decides.
  bool shows_load(const PassiveFreedom& one) const {
    return plan_.which >= 0 &&
           turns_load(one, mechanism_.cases[static_cast<std::size_t>(plan_.which)]);
  }

  bool shows_rate(const PassiveFreedom& one) const {
    return report_.velocity || report_.acceleration || shows(one, false);
  }

 private:
  // A report of all positions has the turns of all bodies.
  bool shows_body(const PassiveFreedom& one) const {
    return report_.position || std::ranges::any_of(trace_, [&](const TracedPoint& point) {
             return one.moves_point(point.body, point.at, mechanism_.geometry.length);
           });
  }

  // A freedom of it, by name or as all are; of some there are only rates.
  bool shows(const PassiveFreedom& one, bool has_position) const {
    for (std::size_t f = 0; f < has_position_.size(); ++f) {
      const auto names = [&](const std::vector<int>& some) {
        return std::ranges::find(some, static_cast<int>(f)) != some.end();
      };
      const bool is_named = names(report_.freedoms) || (has_position && names(report_.positions));
      if ((report_.is_default || is_named) && one.moves(static_cast<int>(f)) &&
          (!has_position || has_position_[f].has_value())) {
        return true;
      }
    }
    return false;
  }

  const MotionPlan& plan_;
  const MotionReport& report_;
  const std::vector<TracedPoint>& trace_;
  const Mechanism& mechanism_;
  std::vector<std::optional<double>> has_position_;
};

void add_names(const PassiveFreedom& one,
               const Topology& topology,
               std::vector<std::string>& names) {
  for (const BodyId body : one.bodies) {
    const std::string name = fmt::format("'{}'", topology.body(body).name);
    if (std::ranges::find(names, name) == names.end()) {
      names.push_back(name);
    }
  }
}

}  // namespace

void add_motion_passive_findings(const FoundMotion& motion,
                                 const Mechanism& mechanism,
                                 Diagnostics& found) {
  if (motion.network.passive_motions.empty() || motion.solution.position_count() == 0) {
    return;
  }
  const PassiveFindings findings(motion, mechanism);
  std::vector<std::string> names;
  bool has_position = false;
  bool has_load = false;
  const std::vector<PassiveFreedom> passive =
      find_passive_freedoms(mechanism, spatial_basis(ScrewKind::twist, mechanism.geometry.length));
  for (const PassiveFreedom& one : passive) {
    if (findings.shows_position(one)) {
      has_position = true;
      has_load = has_load || findings.shows_load(one);
      add_names(one, mechanism.topology, names);
    }
  }
  for (const PassiveFreedom& one : freedoms_of_open_rate(passive, motion.plan, mechanism)) {
    if (findings.shows_rate(one)) {
      add_names(one, mechanism.topology, names);
    }
  }
  if (names.empty()) {
    return;
  }
  constexpr std::size_t kMostBodiesNamed = 4;
  const std::size_t count = names.size();
  if (count > kMostBodiesNamed) {
    names.resize(kMostBodiesNamed);
    names.push_back(fmt::format("{} more", count - kMostBodiesNamed));
  }
  found.warning(
      "W0506",
      motion.plan.where,
      fmt::format("the {} in an idle freedom of {} is not determined, as it moves no other "
                  "body{}",
                  has_position ? "position" : "speed",
                  plain_list(names),
                  has_load
                      ? ": a load that turns with it depends on the steps and on the order of the "
                        "couplings"
                      : ""),
      has_position ? "'kinestat mobility' lists these freedoms; drive one, hold it by a "
                     "coupling, or report what it does not show"
                   : "'kinestat mobility' lists these freedoms; give the case the rate of "
                     "one, hold it by a coupling, or report what it does not show");
}

}  // namespace kinestat
