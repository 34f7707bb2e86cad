// A mechanism ready for analysis: topology, geometry and cases.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "couplings/drawn_coupling.hpp"
#include "description/mechanism_description.hpp"
#include "expression/file_units.hpp"
#include "graph/coupling_graph.hpp"
#include "mechanism/cables/cable_contact.hpp"
#include "mechanism/cases/case.hpp"
#include "mechanism/couplings/coupling_friction.hpp"
#include "mechanism/couplings/freewheel.hpp"
#include "mechanism/curves/curve.hpp"
#include "mechanism/gears/lossy_mesh.hpp"
#include "mechanism/gears/tooth_flanks.hpp"
#include "mechanism/geometry.hpp"
#include "mechanism/inertia/body_mass.hpp"
#include "mechanism/springs/spring.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Everything a pass may need; passes take the parts they use. The graph is connected.
struct Mechanism {
  std::string name;
  Space space = Space::spatial;
  Topology topology;
  Geometry geometry;
  std::vector<CouplingFriction> frictions;  ///< of the couplings that have friction
  std::vector<CableContact> contacts;       ///< of cables with pulleys
  std::vector<Freewheel> freewheels;
  std::vector<ToothRule> tooth_rules;  ///< of teeth that the file writes as couplings
  std::vector<int> one_flanked;        ///< actions: forces of teeth of which the file does not
                                       ///< say where the flank is that another load presses
  std::vector<LossyMesh> lossy_meshes;
  LossModel loss_model = LossModel::carrier;  ///< the model whose efficiency is preferred
  CouplingGraph graph;
  OrderChoice kinematic_order = OrderChoice::minimal;
  OrderChoice static_order = OrderChoice::minimal;
  IndeterminateChoice indeterminate = IndeterminateChoice::report;
  double closure_error = 0.0;        ///< of a moved position over the size; 0 as drawn
  std::vector<bool> is_unplaced;     ///< of each coupling: it has no place, so that its moments are
                                     ///< about the origin
  std::vector<double> compliances;   ///< of each action [m/N or rad/(N·m)]; 0: rigid
  std::vector<int> planet_counts;    ///< of each action: how many equal planets share it
  std::vector<double> load_sharing;  ///< of each action: greatest load of a planet over the mean
  std::vector<BodyMass> masses;      ///< of each body; empty if no body has mass or inertia
  std::vector<DrawnCoupling> drawn_couplings;  ///< of each coupling, if a case has inertia: needed
                                               ///< for accelerations
  std::vector<Spring> springs;
  std::vector<Curve> curves;
  std::vector<Case> cases;
};

/// Whether several equal planets share some actions.
inline bool has_planets(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.planet_counts, [](int count) { return count > 1; });
}

}  // namespace kinestat
