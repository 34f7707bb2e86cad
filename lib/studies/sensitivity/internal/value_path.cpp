#include "studies/sensitivity/internal/value_path.hpp"

namespace kinestat {

std::optional<ReportedValue> quotient(const Dual& a,
                                      QuantityKind of_a,
                                      const Dual& b,
                                      QuantityKind of_b) {
  if (b.value == 0.0) {
    return std::nullopt;
  }
  return ReportedValue{.name = {}, .kind = of_a, .per = of_b, .value = a / b};
}

std::optional<ReportedValue> component(
    const PathParts& parts, const std::vector<std::pair<QuantityKind, Vec3Of<Dual>>>& vectors) {
  const std::string& last = parts.back();
  const auto i = static_cast<std::size_t>(last.size() == 1 ? last[0] - '0' : -1);
  if (i >= 3 * vectors.size()) {
    return std::nullopt;
  }
  const auto& [kind, vector] = vectors[i / 3];
  return as_value(kind, vector[static_cast<Eigen::Index>(i % 3)]);
}

}  // namespace kinestat
