#include "report/certainty_json.hpp"

namespace kinestat {

namespace {

Json rank_json(const std::optional<RankCertainty>& certainty) {
  if (!certainty) {
    return nullptr;
  }
  Json result = object_of(8);
  result["value"] = certainty->rank;
  result["how"] = certainty->how;
  result["lower"] = certainty->lower;
  result["upper"] = certainty->upper;
  result["as_typed"] = certainty->typed ? Json(certainty->typed->rank) : Json(nullptr);
  result["error_probability"] =
      certainty->typed ? number(certainty->typed->error_probability) : Json(nullptr);
  return result;
}

}  // namespace

Json certainty_json(const Certainty& certainty) {
  Json result = object_of(2);
  result["motions"] = rank_json(certainty.motion_rank);
  result["actions"] = rank_json(certainty.action_rank);
  return result;
}

}  // namespace kinestat
