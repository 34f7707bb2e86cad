#include "mechanism/bind/reference_points.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

using PointOfBody = std::pair<Name, PointDescription>;

const std::string& name_of_coupling(const CouplingDescription& coupling) {
  return coupling.name.text;
}

}  // namespace

template <class Scalar>
std::vector<Vec3Of<Scalar>> bind_reference_points(const MechanismDescription& description,
                                                  const std::vector<bool>& has_point,
                                                  const Topology& topology,
                                                  const GeometryOf<Scalar>& geometry,
                                                  EvaluatorOf<Scalar>& evaluator) {
  std::vector<Vec3Of<Scalar>> references(topology.bodies.size(), Vec3Of<Scalar>::Zero());
  std::vector<bool> is_set(topology.bodies.size(), false);
  for (const BodyDescription& body : description.bodies) {
    if (!body.reference) {
      continue;
    }
    const auto at = std::ranges::find(topology.bodies, body.name.text, &BodyTopology::name);
    const auto b = static_cast<std::size_t>(at - topology.bodies.begin());
    references[b] = evaluator.point(*body.reference).value_or(references[b]);
    is_set[b] = true;
  }
  // As drawn on that body, of a coupling whose two bodies are drawn apart.
  const auto point_on =
      [&](BodyId body, const CouplingDescription& coupling, const Vec3Of<Scalar>& point) {
        for (const auto& [name, drawn] :
             coupling.at ? std::span(coupling.at->of_bodies) : std::span<const PointOfBody>()) {
          if (name.text == topology.body(body).name) {
            return evaluator.point(drawn).value_or(point);
          }
        }
        return point;
      };
  auto described = description.couplings.begin();  // in the same order
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    described = std::ranges::find(
        described, description.couplings.end(), topology.couplings[e].name, name_of_coupling);
    if (!has_point[e]) {
      continue;
    }
    for (const BodyId body : {topology.couplings[e].tail, topology.couplings[e].head}) {
      const auto b = static_cast<std::size_t>(body.value);
      if (!is_set[b]) {
        references[b] = point_on(body, *described, geometry.points[e]);
        is_set[b] = true;
      }
    }
  }
  return references;
}

template std::vector<Vec3> bind_reference_points(const MechanismDescription&,
                                                 const std::vector<bool>&,
                                                 const Topology&,
                                                 const GeometryOf<double>&,
                                                 EvaluatorOf<double>&);
template std::vector<Vec3Of<Dual>> bind_reference_points(const MechanismDescription&,
                                                         const std::vector<bool>&,
                                                         const Topology&,
                                                         const GeometryOf<Dual>&,
                                                         EvaluatorOf<Dual>&);
template std::vector<Vec3Of<ExactInput>> bind_reference_points(const MechanismDescription&,
                                                               const std::vector<bool>&,
                                                               const Topology&,
                                                               const GeometryOf<ExactInput>&,
                                                               EvaluatorOf<ExactInput>&);

}  // namespace kinestat
