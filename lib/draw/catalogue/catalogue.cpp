#include "draw/catalogue/catalogue.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "draw/catalogue/catalogue_parts.hpp"

namespace kinestat {

namespace {

bool any_case(const PictureSource& source, bool (*counts)(const CaseAnalysis&)) {
  const std::vector<CaseAnalysis>& cases = source.analysis->cases;
  return source.which ? counts(cases[*source.which]) : std::ranges::any_of(cases, counts);
}

bool has_need(PictureNeed need, const PictureSource& source) {
  switch (need) {
    case PictureNeed::analysis:
      return source.analysis != nullptr;
    case PictureNeed::synthesis:
      return source.synthesis != nullptr;
    case PictureNeed::transmissions:
      return source.transmissions != nullptr;
    case PictureNeed::benchmark:
      return source.benchmark != nullptr;
    case PictureNeed::motion:
      return source.motion != nullptr;
    case PictureNeed::moving:
      return source.moving != nullptr;
    case PictureNeed::placed:
      return source.placed != nullptr;
    case PictureNeed::simulation:
      return source.simulation != nullptr;
    case PictureNeed::sweep:
      return source.sweep != nullptr;
    case PictureNeed::maps:
      return source.maps != nullptr;
  }
  return false;
}

std::vector<PictureKind> all_kinds() {
  std::vector<PictureKind> kinds;
  for (const auto rows : {drawing_kinds(), case_kinds(), study_kinds()}) {
    kinds.insert(kinds.end(), rows.begin(), rows.end());
  }
  return kinds;
}

}  // namespace

std::string why_not_in_cases(const PictureSource& source,
                             bool (*counts)(const CaseAnalysis&),
                             std::string_view what) {
  if (any_case(source, counts)) {
    return "";
  }
  return source.which
             ? fmt::format(
                   "case '{}' has no {}", source.analysis->cases[*source.which].which.label, what)
             : fmt::format("no case has {}", what);
}

std::span<const PictureKind> picture_kinds() {
  static const std::vector<PictureKind> kinds = all_kinds();
  return kinds;
}

const PictureKind* find_picture_kind(std::string_view name) {
  const std::span<const PictureKind> kinds = picture_kinds();
  const auto at = std::ranges::find(kinds, name, &PictureKind::name);
  return at == kinds.end() ? nullptr : &*at;
}

bool has_picture(const PictureKind& kind, const PictureSource& source) {
  return has_need(kind.need, source) && kind.why_not(source).empty();
}

}  // namespace kinestat
