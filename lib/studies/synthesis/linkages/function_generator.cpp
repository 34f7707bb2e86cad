#include "studies/synthesis/linkages/function_generator.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// As far as its digits tell, a link has no length: then the dyad is the frame, or nothing moves.
bool has_links(const AngleFunction& function, const Dyad& coupler) {
  const double shortest = std::min({std::abs(coupler.circle_point - function.input_pivot),
                                    std::abs(coupler.centre_point - function.output_pivot),
                                    coupler.length});
  const double ground = std::abs(function.output_pivot - function.input_pivot);
  return shortest > std::max(kConsistency, std::pow(10.0, -coupler.digits)) * ground;
}

// With the digits of the coupler that it carries.
Dyad crank_of(const Dyad& coupler, const Point& pivot, const Point& joint, const Point& bound) {
  Dyad crank = coupler;
  crank.circle_point = joint;
  crank.circle_bound = bound;
  crank.centre_point = pivot;
  crank.centre_bound = {0.0, 0.0};
  crank.length = std::abs(joint - pivot);
  return crank;
}

// By how much a point of a link moves while this turns from the first position.
Point shift_of(const Point& pivot, const Point& point, double angle) {
  return (unit_vector(angle) - 1.0) * (point - pivot);
}

}  // namespace

std::vector<PositionJets> seen_from_output(const AngleFunction& function) {
  std::vector<PositionJets> positions;
  const Point ground = function.input_pivot - function.output_pivot;
  for (std::size_t i = 0; i < function.input.size(); ++i) {
    const double angle = function.input[i] - function.output[i];
    positions.push_back(finite_position((unit_vector(-function.output[i]) - 1.0) * ground +
                                            (1.0 - unit_vector(angle)) * function.input_pivot,
                                        angle));
  }
  return positions;
}

std::vector<Dyad> cranks_of_couplers(const AngleFunction& function,
                                     std::span<const Dyad> couplers) {
  std::vector<Dyad> cranks;
  for (const Dyad& coupler : couplers) {
    if (coupler.kind != DyadKind::crank || !has_links(function, coupler)) {
      continue;
    }
    cranks.push_back(
        crank_of(coupler, function.input_pivot, coupler.circle_point, coupler.circle_bound));
    cranks.push_back(
        crank_of(coupler, function.output_pivot, coupler.centre_point, coupler.centre_bound));
  }
  return cranks;
}

std::vector<PositionJets> coupler_positions(const AngleFunction& function,
                                            const Linkage& four_bar) {
  const Point on_input = four_bar.one.circle_point;
  const Point on_output = four_bar.other.circle_point;
  const Point drawn = on_output - on_input;
  std::vector<PositionJets> positions;
  for (std::size_t i = 0; i < function.input.size(); ++i) {
    const Point moved = shift_of(function.input_pivot, on_input, function.input[i]);
    const Point across = shift_of(function.output_pivot, on_output, function.output[i]) - moved;
    const double angle = std::arg((drawn + across) / drawn);
    positions.push_back(finite_position(moved + (1.0 - unit_vector(angle)) * on_input, angle));
  }
  return positions;
}

}  // namespace kinestat
