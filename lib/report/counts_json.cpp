#include "report/counts_json.hpp"

#include "report/solution_json.hpp"

namespace kinestat {

namespace {

Json side_json(const SideCounts& side) {
  Json result = object_of(8);
  result["order"] = side.motions.order;
  result["gross_freedom"] = side.motions.gross_freedom;
  result["rank"] = side.motions.rank;
  result["net_freedom"] = side.motions.net_freedom;
  result["net_constraint"] = side.motions.net_constraint;
  if (!side.actions) {
    result["statics"] = nullptr;
    return result;
  }
  Json& statics = result["statics"];
  statics["order"] = side.actions->order;
  statics["gross_constraint"] = side.actions->gross_constraint;
  statics["rank"] = side.actions->rank;
  statics["net_constraint"] = side.actions->net_constraint;
  statics["net_freedom"] = side.actions->net_freedom;
  return result;
}

}  // namespace

Json mobility_counts_json(const MobilityCounts& counts) {
  Json result = object_of(8);
  result["minimal"] = side_json(counts.minimal);
  result["planar"] = counts.planar ? side_json(*counts.planar) : Json(nullptr);
  result["spatial"] = side_json(counts.spatial);
  result["evidence"] = evidence_json(counts.evidence);
  return result;
}

}  // namespace kinestat
