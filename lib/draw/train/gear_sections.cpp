#include "draw/train/gear_sections.hpp"

#include <algorithm>

#include "core/contract.hpp"

namespace kinestat {

namespace {

std::optional<GearSection> lay_out(std::optional<SchemeTrain> train,
                                   const Analysis& analysis,
                                   const GearSchemeOptions& options) {
  if (!train) {
    return std::nullopt;
  }
  SchemeLayout layout = lay_out_scheme(*train);
  const bool is_developed = train->axis_count > 1;
  if (is_developed && (!layout.is_complete || layout.crossings > 0)) {
    if (std::optional<SchemeTrain> half = find_half_section(analysis, options)) {
      SchemeLayout other = lay_out_scheme(*half);
      if (!layout.is_complete || other.crossings < layout.crossings) {
        return GearSection{.train = std::move(*half), .layout = std::move(other)};
      }
    }
  }
  if (is_developed && !layout.is_complete) {
    return std::nullopt;
  }
  return GearSection{.train = std::move(*train), .layout = std::move(layout)};
}

}  // namespace

std::optional<GearSection> find_gear_section(const Analysis& analysis,
                                             const GearSchemeOptions& options) {
  return lay_out(find_scheme_train(analysis, options), analysis, options);
}

std::optional<GearSection> GearSections::find(const Analysis& analysis,
                                              const GearSchemeOptions& options) {
  std::optional<SchemeTrain> train = find_scheme_train(analysis, options);
  if (!train) {
    return std::nullopt;
  }
  SchemeTrain idle = *train;
  for (SchemeElement& element : idle.elements) {
    element.is_engaged = false;
  }
  auto at = std::ranges::find_if(found_, [&](const auto& one) { return one.first == idle; });
  if (at == found_.end()) {
    found_.emplace_back(std::move(idle), lay_out(train, analysis, options));
    at = found_.end() - 1;
  }
  std::optional<GearSection> section = at->second;
  if (section) {
    // Half section or not, both have every actuator that turns.
    KINESTAT_EXPECTS(section->train.elements.size() == train->elements.size());
    for (std::size_t i = 0; i < train->elements.size(); ++i) {
      section->train.elements[i].is_engaged = train->elements[i].is_engaged;
    }
  }
  return section;
}

}  // namespace kinestat
