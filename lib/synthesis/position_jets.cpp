#include "synthesis/position_jets.hpp"

#include "core/contract.hpp"
#include "core/index.hpp"
#include "synthesis/internal/jets.hpp"

namespace kinestat {

namespace {

// The derivatives of (df/dt) / γ' by t from those of df/dt, order by order (Leibniz). `speed` is γ'
// with its derivatives by t.
std::vector<double> over_speed(const std::vector<double>& slope, const std::vector<double>& speed) {
  std::vector<double> result(slope.size());
  for (std::size_t n = 0; n < slope.size(); ++n) {
    double sum = slope[n];
    for (std::size_t i = 1; i <= n; ++i) {
      sum -= binomial(n, i) * speed[i] * result[n - i];
    }
    result[n] = sum / speed[0];
  }
  return result;
}

// Derivatives of f by γ from those by t: d/dγ = (1/γ') d/dt, again and again.
std::vector<double> by_angle(std::vector<double> jets, const std::vector<double>& speed) {
  const std::size_t count = jets.size();
  std::vector<double> result;
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(jets[0]);
    jets = over_speed(std::vector<double>(jets.begin() + 1, jets.end()), speed);
  }
  return result;
}

}  // namespace

PositionJets finite_position(const Point& at, double angle) {
  return {.x = {at.real()}, .y = {at.imag()}, .angle = {angle}};
}

Point origin(const PositionJets& position, int k) {
  return {position.x[at(k)], position.y[at(k)]};
}

std::vector<Point> rotation_jets(const PositionJets& position) {
  const auto [cosine, sine] = turn_jets(position.angle);
  std::vector<Point> result;
  for (std::size_t k = 0; k < cosine.size(); ++k) {
    result.emplace_back(cosine[k], sine[k]);
  }
  return result;
}

std::vector<Point> point_jets(const PositionJets& position, const Point& moving) {
  std::vector<Point> result = rotation_jets(position);
  for (int k = 0; k < position.order(); ++k) {
    result[at(k)] = result[at(k)] * moving + origin(position, k);
  }
  return result;
}

PositionJets by_angle(const PositionJets& position) {
  PositionJets result = position;
  if (position.order() < 2) {
    return result;
  }
  const std::vector<double> speed(position.angle.begin() + 1, position.angle.end());
  KINESTAT_EXPECTS(speed[0] != 0.0);
  result.x = by_angle(position.x, speed);
  result.y = by_angle(position.y, speed);
  result.angle.assign(position.angle.size(), 0.0);
  result.angle[0] = position.angle[0];
  result.angle[1] = 1.0;
  result.is_directed = false;
  return result;
}

int position_count(std::span<const PositionJets> positions) {
  int count = 0;
  for (const PositionJets& position : positions) {
    count += position.order();
  }
  return count;
}

std::string form_of(std::span<const PositionJets> positions) {
  std::string form;
  for (const PositionJets& position : positions) {
    form += form.empty() ? "" : "-";
    form += std::string(position.angle.size(), 'P');
  }
  return form;
}

}  // namespace kinestat
