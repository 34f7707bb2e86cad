#include "studies/motion/task/case_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "math/elimination/uncertain_inverse.hpp"
#include "studies/motion/contact_rates.hpp"

namespace kinestat {

// In radians and sizes of the mechanism.
struct CaseSpeedSolver::Response {
  MatX rates;   // of what is known, a column for each drive alone
  MatX bounds;  // of these
  VecX known;   // of the case, without what the open freedoms add
};

const Primary* CaseSpeedSolver::known_of(const PlannedDrive& drive) const {
  const auto one = std::ranges::find(which_.motions, drive.freedom, &Primary::index);
  return one == which_.motions.end() ? nullptr : &*one;
}

double CaseSpeedSolver::unit_of(int freedom) const {
  return mechanism_.topology.freedoms[at(freedom)].is_rotation ? 1.0 : network_.length;
}

// Whether the drives leave it to itself, so that a case may give it any rate.
bool CaseSpeedSolver::is_open(int freedom, const Configuration& configuration) const {
  if (network_.passive_motions.empty()) {
    return false;
  }
  const auto rate_given = [&](double speed) {
    const GivenSpeeds speeds{.drives = std::vector<DriveSpeed>(plan_.drives.size(), {.speed = 1.0}),
                             .passive = {{.freedom = freedom, .speed = speed}}};
    const MotionState state = states_.solve(configuration, speeds, StateDetail::velocity);
    return state.is_singular ? 0.0 : state.rates[at(freedom)].value_or(0.0);
  };
  return std::abs(rate_given(1.0) - rate_given(0.0)) > 0.5;
}

CaseSpeeds CaseSpeedSolver::find(const Configuration& configuration, StateDetail detail) const {
  GivenSpeeds given;
  std::size_t driven = 0;
  for (const PlannedDrive& drive : plan_.drives) {
    const Primary* known = known_of(drive);
    given.drives.push_back(
        {.speed = known == nullptr ? 0.0 : known->value,
         .acceleration = known == nullptr ? 0.0 : acceleration_of(which_, drive.freedom),
         .speed_bound = 0.0,
         .acceleration_bound = 0.0});
    driven += known == nullptr ? 0 : 1;
  }
  std::vector<const Primary*> known;
  for (const Primary& one : which_.motions) {
    const bool is_driven =
        std::ranges::find(plan_.drives, one.index, &PlannedDrive::freedom) != plan_.drives.end();
    if (!is_driven && is_open(one.index, configuration)) {
      given.passive.push_back({.freedom = one.index, .speed = one.value});
    } else {
      known.push_back(&one);
    }
  }
  if (known.size() == driven && driven == plan_.drives.size()) {
    return {.known = SpeedsKnown::all, .speeds = std::move(given)};
  }
  GivenSpeeds rest = given;
  rest.drives.assign(given.drives.size(), {});
  CaseSpeeds solved = solve(known, rest, configuration, detail);
  const bool is_given = driven == plan_.drives.size();
  if (is_given && solved.known == SpeedsKnown::not_by_state) {
    return {.known = SpeedsKnown::all, .speeds = std::move(given)};
  }
  return solved;
}

// False where the position is singular, or the motion has no rate for what is known.
bool CaseSpeedSolver::find_response(const std::vector<const Primary*>& known,
                                    const GivenSpeeds& rest,
                                    const Configuration& configuration,
                                    StateDetail detail,
                                    Response& response) const {
  const auto rows = static_cast<Eigen::Index>(known.size());
  const auto columns = static_cast<Eigen::Index>(plan_.drives.size());
  response = {.rates = MatX::Zero(rows, columns),
              .bounds = MatX::Zero(rows, columns),
              .known = VecX::Zero(rows)};
  for (Eigen::Index d = -1; d < columns; ++d) {
    GivenSpeeds speeds = rest;
    if (d >= 0) {
      const auto drive = static_cast<std::size_t>(d);
      speeds.drives[drive].speed = unit_of(plan_.drives[drive].freedom);
      for (PassiveSpeed& one : speeds.passive) {
        one.speed = 0.0;
      }
    }
    MotionState state = states_.solve_bounded(configuration, speeds, StateDetail::velocity);
    if (state.is_singular) {
      return false;
    }
    if (detail == StateDetail::velocity) {  // accelerations of contacts are not known
      add_contact_rates(network_, drawn_, mechanism_, state);
    }
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Primary& one = *known[static_cast<std::size_t>(k)];
      const double unit = unit_of(one.index);
      const std::optional<double> rate = state.rates[at(one.index)];
      if (!rate) {
        return false;
      }
      if (d < 0) {
        response.known[k] = (one.value - *rate) / unit;
      } else {
        response.rates(k, d) = *rate / unit;
        response.bounds(k, d) = state.bounds.rates[at(one.index)] / unit;
      }
    }
  }
  return true;
}

CaseSpeeds CaseSpeedSolver::solve(const std::vector<const Primary*>& known,
                                  const GivenSpeeds& rest,
                                  const Configuration& configuration,
                                  StateDetail detail) const {
  if (known.empty()) {
    return {.known = SpeedsKnown::too_few, .speeds = {}};
  }
  Response response;
  if (!find_response(known, rest, configuration, detail, response)) {
    return {.known = SpeedsKnown::not_by_state, .speeds = {}};
  }
  const std::size_t count = plan_.drives.size();
  const UncertainInverse found = find_uncertain_inverse(response.rates, response.bounds.sum());
  const auto rank = static_cast<std::size_t>(found.rank);
  if (rank < count) {
    return {.known = SpeedsKnown::too_few, .speeds = {}};
  }
  if (rank < known.size()) {
    return {.known = SpeedsKnown::dependent, .speeds = {}};
  }
  const MatX& inverse = found.inverse;
  const auto bound_of = [&](const VecX& solved, const VecX& right) -> VecX {
    return inverse.cwiseAbs() * (response.bounds * solved.cwiseAbs() + right);
  };
  const VecX speed = inverse * response.known;
  const VecX speed_bound = bound_of(speed, 4.0 * kEpsilon * response.known.cwiseAbs());
  CaseSpeeds result{.known = SpeedsKnown::all, .speeds = rest};
  for (std::size_t d = 0; d < count; ++d) {
    const double unit = unit_of(plan_.drives[d].freedom);
    const auto i = static_cast<Eigen::Index>(d);
    const Primary* exact = known_of(plan_.drives[d]);
    result.speeds.drives[d] = {.speed = exact == nullptr ? unit * speed[i] : exact->value,
                               .speed_bound = exact == nullptr ? unit * speed_bound[i] : 0.0};
  }
  if (detail == StateDetail::velocity) {
    return result;
  }
  const MotionState state = states_.solve_bounded(configuration, result.speeds, detail);
  if (state.rate_rates.empty()) {
    return result;
  }
  VecX bend(static_cast<Eigen::Index>(known.size()));
  VecX bend_bound = bend;
  for (std::size_t k = 0; k < known.size(); ++k) {
    const std::size_t freedom = at(known[k]->index);
    const double unit = unit_of(known[k]->index);
    bend[static_cast<Eigen::Index>(k)] =
        (acceleration_of(which_, known[k]->index) - state.rate_rates[freedom].value_or(0.0)) / unit;
    bend_bound[static_cast<Eigen::Index>(k)] = state.bounds.rate_rates[freedom] / unit;
  }
  const VecX acceleration = inverse * bend;
  const VecX acceleration_bound = bound_of(acceleration, bend_bound);
  for (std::size_t d = 0; d < count; ++d) {
    if (known_of(plan_.drives[d]) != nullptr) {
      result.speeds.drives[d].acceleration = acceleration_of(which_, plan_.drives[d].freedom);
    } else {
      const double unit = unit_of(plan_.drives[d].freedom);
      const auto i = static_cast<Eigen::Index>(d);
      result.speeds.drives[d].acceleration = unit * acceleration[i];
      result.speeds.drives[d].acceleration_bound = unit * acceleration_bound[i];
    }
  }
  return result;
}

}  // namespace kinestat
