#include "report/analysis_json.hpp"

#include "core/diagnostic.hpp"
#include "kinematics/bounded_motion.hpp"
#include "report/affine_report.hpp"
#include "report/counts_json.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"
#include "report/mechanism_json.hpp"
#include "report/power_json.hpp"
#include "report/ratio_in_units.hpp"
#include "report/shift_json.hpp"
#include "report/solution_json.hpp"
#include "report/statics_json.hpp"

namespace kinestat {

namespace {

Json primary_json(const Mechanism& mechanism, const Case& which) {
  Json result = object_of(8);
  result["motion"] = Json::array();
  for (const Primary& primary : which.motions) {
    result["motion"].push_back(mechanism.topology.freedom_name(primary.index));
  }
  result["action"] = Json::array();
  for (const Primary& primary : which.actions) {
    result["action"].push_back(mechanism.topology.action_name(primary.index));
  }
  return result;
}

Json kinematics_json(const Mechanism& mechanism,
                     const KinematicSolution& motion,
                     const InUnits& in) {
  const Topology& topology = mechanism.topology;
  const bool is_solved = motion.status == SolveStatus::solved;
  Json result = object_of(8);
  result["status"] = word_of(motion.status);
  result["order"] = motion.counts.order;
  result["net_freedom"] = motion.counts.net_freedom;
  Json& freedoms = result["freedoms"] = object_of(topology.freedoms.size());
  for (std::size_t f = 0; f < topology.freedoms.size(); ++f) {
    appended(freedoms, topology.freedom_name(static_cast<int>(f))) =
        is_solved ? number(in.rate(motion.rates[f], topology.freedoms[f].is_rotation))
                  : Json(nullptr);
  }
  Json& bodies = result["bodies"] = object_of(topology.bodies.size());
  for (std::size_t b = 0; is_solved && b < topology.bodies.size(); ++b) {
    const BoundedTwist twist = bounded_body(motion, BodyId{static_cast<int>(b)});
    const Vec3& at = mechanism.geometry.references[b];
    const Vec3& origin = mechanism.geometry.origin;
    Json& body = appended(bodies, topology.bodies[b].name);
    body["twist"] = sixfold_of(about_world(twist, origin).zeroed(), in);
    body["angular"] = vector(in.angular(twist.angular.zeroed()));
    body["linear"] = vector(in.linear(velocity_at(twist, at - origin).zeroed()));
    body["at"] = vector(in.length(at));
    body["screw"] = screw_json(find_axis(twist, mechanism.geometry.length), origin, in);
  }
  result["evidence"] = evidence_json(
      motion.evidence, is_solved ? std::optional(motion.residual) : std::nullopt, motion.answer);
  return result;
}

Json case_json(const Analysis& analysis, const CaseAnalysis& one) {
  const Mechanism& mechanism = analysis.mechanism;
  const FileUnits& units = analysis.description.units;
  const InUnits in(units);
  Json result = object_of(8);
  result["primary"] = primary_json(mechanism, one.which);
  if (one.ratios) {
    result["ratio"] = number(ratio_in_units(one, mechanism, units).value);
    result["torque_ratio"] = number(torque_ratio_in_units(one, mechanism, units).value);
    if (!one.ratios->reason.empty()) {
      result["reason"] = one.ratios->reason;
    }
    result["evidence"]["ratio_error_bound"] = number(one.ratios->ratio_bound);
    result["evidence"]["torque_ratio_error_bound"] = number(one.ratios->torque_ratio_bound);
  }
  if (one.motion) {
    result["kinematics"] = kinematics_json(mechanism, *one.motion, in);
  }
  if (one.action) {
    result["statics"] = statics_json(mechanism, one, in);
  }
  if (one.power) {
    result["power"] = power_json(mechanism, one, in);
  }
  if (!analysis.free_parameters.empty()) {
    result["affine"] = affine_json(analysis, one);
  }
  return result;
}

}  // namespace

Json analysis_json(const Analysis& analysis) {
  Json result = report_head(analysis.file, analysis.description);
  result["graph"] = graph_json(analysis.mechanism, analysis.description.units);
  result["mobility"] = mobility_counts_json(analysis.mobility);
  result["cases"] = object_of(8);
  for (const CaseAnalysis& one : analysis.cases) {
    result["cases"][one.which.label] = case_json(analysis, one);
  }
  if (analysis.shift) {
    result["shift"] = shift_json(analysis);
  }
  return result;
}

Json diagnostics_json(const Diagnostics& found) {
  Json result = Json::array();
  for (const Diagnostic& one : found.items()) {
    Json entry;
    entry["severity"] = one.severity == Severity::error ? "error" : "warning";
    entry["code"] = one.code;
    entry["line"] = one.where.line;
    entry["column"] = one.where.column;
    entry["message"] = one.message;
    entry["hint"] = one.hint;
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace kinestat
