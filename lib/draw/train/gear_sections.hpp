// The sections of one gear train, each found once: cases mostly differ in what they engage.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "draw/train/scheme_layout.hpp"
#include "draw/train/scheme_train.hpp"

namespace kinestat {

/// A train and where everything of it stands.
struct GearSection {
  SchemeTrain train;
  SchemeLayout layout;
};

/// The developed section, unless something finds no way in it or shafts cross that do not in a half
/// section. Empty where there is no train, or no way for its shafts.
std::optional<GearSection> find_gear_section(const Analysis& analysis,
                                             const GearSchemeOptions& options);

/// Of one analysis.
class GearSections {
 public:
  /// The same as find_gear_section, which is asked only for what no case had before.
  std::optional<GearSection> find(const Analysis& analysis, const GearSchemeOptions& options);

 private:
  std::vector<std::pair<SchemeTrain, std::optional<GearSection>>> found_;  // with nothing engaged
};

}  // namespace kinestat
