#include "studies/synthesis/positions/position_jets.hpp"

#include "core/index.hpp"
#include "studies/synthesis/positions/internal/jets.hpp"

namespace kinestat {

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
