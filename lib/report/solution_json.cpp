#include "report/solution_json.hpp"

namespace kinestat {

Json sixfold_of(const Twist& twist, const InUnits& in) {
  return sixfold(in.angular(twist.angular), in.linear(twist.linear));
}

Json sixfold_of(const Wrench& wrench, const InUnits& in) {
  return sixfold(in.moment(wrench.moment), in.force(wrench.force));
}

Json screw_json(const std::optional<ScrewAxis>& axis, const Vec3& origin, const InUnits& in) {
  if (!axis) {
    return nullptr;
  }
  Json result = object_of(8);
  result["direction"] = vector(axis->direction);
  result["point"] = axis->point ? vector(in.length(Vec3(*axis->point + origin))) : Json(nullptr);
  result["pitch"] = axis->pitch ? number(in.length(*axis->pitch)) : Json(nullptr);
  return result;
}

Json evidence_json(const RankEvidence& rank) {
  Json result = object_of(8);
  result["method"] = rank.method;
  result["rank"] = rank.rank;
  result["smallest_pivot"] = number(rank.smallest_pivot);
  result["largest_dropped"] = number(rank.largest_dropped);
  result["gap"] = number(rank.gap());
  return result;
}

Json evidence_json(const RankEvidence& rank,
                   const std::optional<double>& residual,
                   const AnswerEvidence& answer) {
  Json result = evidence_json(rank);
  result["residual"] = residual ? number(*residual) : Json(nullptr);
  result["rung"] = residual ? Json(word_of(answer.rung)) : Json(nullptr);
  const bool has_bound = residual && answer.error_bound;
  result["error_bound"] = has_bound ? number(*answer.error_bound) : Json(nullptr);
  result["exact"] = answer.is_exact;
  result["refers_to"] = !has_bound        ? Json(nullptr)
                        : answer.is_typed ? Json("numbers as typed")
                                          : Json("numbers rounded to double");
  return result;
}

}  // namespace kinestat
