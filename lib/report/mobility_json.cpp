#include "report/mobility_json.hpp"

#include "mobility/counts_record.hpp"
#include "network/evidence_record.hpp"
#include "report/json_archive.hpp"
#include "report/mobility_words.hpp"
#include "screw/screw_record.hpp"

namespace kinestat {

namespace {

class MobilityJson {
 public:
  explicit MobilityJson(const MobilityAnalysis& analysis)
      : analysis_(analysis), units_(analysis.description.units), in_(units_) {}

  Json run() const {
    const Mobility& mobility = analysis_.mobility;
    Json result = object_of(16);
    result["grubler"]["spatial"] = grubler_json(mobility.spatial);
    result["grubler"]["planar"] = mobility.planar ? grubler_json(*mobility.planar) : Json(nullptr);
    result["circuits"] = analysis_.mechanism.graph.circuit_count();
    if (mobility.exact) {
      const MobilityCounts& counts = mobility.exact->counts;
      result["counts"] = json_of(counts_record(), counts, units_);
      result["counts"]["evidence"] = json_of(rank_evidence_record(), counts.evidence, units_);
    } else {
      result["counts"] = nullptr;
    }
    result["reshetov"] = mobility.reshetov ? reshetov_json(*mobility.reshetov) : Json(nullptr);
    result["motions"] = mobility.exact ? motions_json(mobility.exact->motions) : Json(nullptr);
    result["finite"] = analysis_.finite ? finite_json(*analysis_.finite) : Json(nullptr);
    result["redundancies"] = mobility.exact ? redundancies_json(*mobility.exact) : Json(nullptr);
    result["repairs"] = mobility.exact ? repairs_json(mobility.exact->repairs) : Json(nullptr);
    result["remarks"] = mobility_remarks(analysis_);
    return result;
  }

 private:
  const std::string& coupling_name(CouplingId id) const {
    return analysis_.mechanism.topology.coupling(id).name;
  }

  Json names_of(const std::vector<CouplingId>& couplings) const {
    Json names = Json::array();
    for (const CouplingId id : couplings) {
      names.push_back(coupling_name(id));
    }
    return names;
  }

  Json grubler_json(const GrublerCount& count) const {
    Json result = object_of(8);
    result["order"] = count.order;
    result["bodies"] = count.bodies;
    result["couplings"] = count.couplings;
    result["freedoms"] = count.freedoms;
    result["mobility"] = count.mobility;
    result["classes"] = object_of(8);
    for (std::size_t i = 0; i < count.classes.size(); ++i) {
      const PairClass& one = count.classes[i];
      if (!one.couplings.empty()) {
        Json& entry = result["classes"][class_words(i)];
        entry["couplings"] = names_of(one.couplings);
        entry["freedoms"] = one.freedoms;
      }
    }
    return result;
  }

  Json reshetov_json(const ReshetovTable& table) const {
    const Topology& topology = analysis_.in_space.topology;
    Json result = object_of(8);
    result["mobility"] = table.mobility;
    result["redundant"] = table.redundant;
    result["circuits"] = object_of(table.circuits.size());
    for (const ReshetovCircuit& circuit : table.circuits) {
      Json& entry = result["circuits"][coupling_name(circuit.chord)];
      entry["couplings"] = names_of(circuit.couplings);
      entry["offered"] = object_of(8);
      entry["covered_by"] = object_of(8);
      entry["missing"] = Json::array();
      for (std::size_t i = 0; i < kClosures.size(); ++i) {
        entry["offered"][kClosures[i]] = circuit.offered[i];
        const std::optional<int>& cover = circuit.covered_by[i];
        entry["covered_by"][kClosures[i]] =
            cover ? Json(topology.freedom_name(*cover)) : Json(nullptr);
        if (!cover) {
          entry["missing"].push_back(kClosures[i]);
        }
      }
      entry["oblique_rotations"] = circuit.oblique_rotations;
      entry["oblique_translations"] = circuit.oblique_translations;
    }
    result["unused"] = Json::array();
    for (const int f : table.unused) {
      result["unused"].push_back(topology.freedom_name(f));
    }
    if (analysis_.mobility.exact) {
      const MotionCounts& exact = analysis_.mobility.exact->counts.spatial.motions;
      result["agrees"] =
          table.mobility == exact.net_freedom && table.redundant == exact.net_constraint;
    } else {
      result["agrees"] = nullptr;
    }
    return result;
  }

  double rate_factor(int freedom) const {
    const bool turns =
        analysis_.mechanism.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation;
    return units_.factor(turns ? QuantityKind::angular_velocity : QuantityKind::velocity);
  }

  // One unit of the first freedom.
  Json motions_json(const MotionSpace& space) const {
    const Topology& topology = analysis_.mechanism.topology;
    const Geometry& geometry = analysis_.mechanism.geometry;
    Json result = Json::array();
    for (const FreeMotion& motion : space.motions) {
      const double first = rate_factor(motion.first);
      Json entry = object_of(8);
      entry["passive"] = motion.is_passive();
      entry["freedoms"] = object_of(topology.freedoms.size());
      for (int f = 0; f < topology.freedom_count(); ++f) {
        if (motion.rates[f] != 0.0) {
          entry["freedoms"][topology.freedom_name(f)] =
              number(motion.rates[f] * (first / rate_factor(f)));
        }
      }
      entry["bodies"] = object_of(topology.bodies.size());
      for (std::size_t b = 1; b < topology.bodies.size(); ++b) {
        const Twist twist = first * motion.bodies[b];
        Json& body = entry["bodies"][topology.bodies[b].name];
        const Twist in_world = about_world(twist, geometry.origin);
        body["twist"] = sixfold(in_.angular(in_world.angular), in_.linear(in_world.linear));
        body["screw"] = axis_json(motion.axis_of(b, geometry.length), geometry);
      }
      result.push_back(std::move(entry));
    }
    return result;
  }

  // One trial a motion, in their order.
  Json finite_json(const FiniteMobility& finite) const {
    Json result = object_of(5);
    result["motions"] = Json::array();
    for (const FreedomTrial& trial : finite.trials) {
      Json entry = object_of(3);
      entry["persistence"] = word_of(trial.persistence);
      entry["step"] = number(trial.step);
      entry["misclosure"] = number(trial.misclosure);
      result["motions"].push_back(std::move(entry));
    }
    result["drawn_freedom"] = finite.drawn_freedom;
    result["nearby_freedom"] = finite.nearby_freedom;
    result["singular"] = finite.is_singular();
    result["gained"] = names_of(finite.gained);
    return result;
  }

  Json redundancies_json(const ExactMobility& exact) const {
    Json result = object_of(8);
    result["spatial"] = redundancy_json(exact.spatial, analysis_.in_space);
    result["planar"] =
        exact.planar ? redundancy_json(*exact.planar, analysis_.mechanism) : Json(nullptr);
    result["minimal"] = redundancy_json(exact.minimal, analysis_.mechanism);
    return result;
  }

  Json redundancy_json(const Redundancies& redundancies, const Mechanism& mechanism) const {
    Json result = object_of(8);
    result["order"] = redundancies.order;
    result["count"] = redundancies.net_constraint;
    result["borne"] = redundancies.borne;
    result["self_stresses"] = Json::array();
    for (const RedundantConstraint& one : redundancies.constraints) {
      result["self_stresses"].push_back(constraint_json(one, mechanism));
    }
    return result;
  }

  Json axis_json(const std::optional<ScrewAxis>& axis, const Geometry& geometry) const {
    const auto view = view_of(axis, geometry.origin);
    return view ? json_of(axis_record(), *view, units_) : Json();
  }

  // Circuits: 1 of the file's force or moment goes round; others: 1 of the first action.
  Json constraint_json(const RedundantConstraint& one, const Mechanism& mechanism) const {
    const Topology& topology = mechanism.topology;
    const auto factor = [&](bool is_couple) {
      return units_.factor(is_couple ? QuantityKind::moment : QuantityKind::force);
    };
    std::optional<double> first;
    if (one.axis) {
      first = factor(!one.axis->pitch);
    }
    Json result = object_of(8);
    result["name"] = constraint_words(analysis_, one);
    result["circuit"] = one.chord ? Json(coupling_name(*one.chord)) : Json(nullptr);
    result["screw"] = axis_json(one.axis, mechanism.geometry);
    result["actions"] = object_of(8);
    for (int a = 0; a < topology.action_count(); ++a) {
      if (one.magnitudes[a] != 0.0) {
        const bool is_couple = topology.actions[static_cast<std::size_t>(a)].is_couple;
        first = first.value_or(factor(is_couple));
        result["actions"][topology.action_name(a)] =
            number(one.magnitudes[a] * (*first / factor(is_couple)));
      }
    }
    return result;
  }

  Json repairs_json(const std::vector<Repair>& repairs) const {
    Json result = Json::array();
    for (const Repair& repair : repairs) {
      Json entry = object_of(8);
      entry["changes"] = object_of(repair.changes.size());
      for (const CouplingChange& change : repair.changes) {
        Json& one = entry["changes"][coupling_name(change.coupling)];
        one["to"] = change.to ? Json(word_of(*change.to)) : Json(nullptr);
        one["left_out"] = change.is_left_out;
        one["added"] = Json::array();
        for (const Twist& twist : change.added) {
          one["added"].push_back(freedom_words(twist));
        }
      }
      entry["removes"] = repair.freed;
      entry["net_freedom"] = repair.after.net_freedom;
      entry["net_constraint"] = repair.after.net_constraint;
      entry["verified"] = repair.is_verified;
      result.push_back(std::move(entry));
    }
    return result;
  }

  const MobilityAnalysis& analysis_;
  const FileUnits& units_;
  InUnits in_;
};

}  // namespace

Json mobility_json(const MobilityAnalysis& analysis) {
  return MobilityJson(analysis).run();
}

}  // namespace kinestat
