#include "pages/figures.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "draw/text_styles.hpp"

namespace kinestat {

namespace {

using NamedPlace = std::pair<std::string_view, PicturePlace>;

// Those whose place what they need does not tell.
constexpr auto kPlaces = std::to_array<NamedPlace>({
    {"motion-graph", PicturePlace::graphs},
    {"action-graph", PicturePlace::graphs},
    {"circuits", PicturePlace::graphs},
    {"cut-sets", PicturePlace::graphs},
    {"speeds", PicturePlace::velocities},
    {"lever", PicturePlace::velocities},
    {"torques", PicturePlace::actions},
    {"forces", PicturePlace::actions},
    {"power-flow", PicturePlace::power},
    {"shift-matrix", PicturePlace::shift},
    {"ratio-ladder", PicturePlace::shift},
    {"trade-offs", PicturePlace::charts},
});

// Pictures of all cases, which show one alone beside its tables.
bool compares(PicturePlace place) {
  return place == PicturePlace::velocities || place == PicturePlace::actions;
}

PicturePlace place_of(const PictureKind& kind) {
  const auto at = std::ranges::find(kPlaces, kind.name, &NamedPlace::first);
  if (at != kPlaces.end()) {
    return at->second;
  }
  switch (kind.need) {
    case PictureNeed::motion:
    case PictureNeed::moving:
    case PictureNeed::placed:
      return PicturePlace::motion;
    case PictureNeed::simulation:
      return PicturePlace::simulation;
    case PictureNeed::sweep:
      return PicturePlace::sweep;
    case PictureNeed::synthesis:
    case PictureNeed::transmissions:
      return PicturePlace::synthesis;
    case PictureNeed::maps:
      return PicturePlace::duty;
    case PictureNeed::analysis:
    case PictureNeed::benchmark:
      break;
  }
  return kind.scope == PictureScope::one_case ? PicturePlace::one_case : PicturePlace::structure;
}

}  // namespace

std::string caption_of(const std::string& title, const std::string& name) {
  const std::string end = ": " + name;
  return title.ends_with(end) ? title.substr(0, title.size() - end.size()) : title;
}

void add_caption(int number, const std::string& caption, Html& html) {
  html.open("figcaption");
  html.element("b", fmt::format("Figure {}. ", number));
  html.text(caption);
  html.close();
}

std::vector<Picture> pictures_at(PicturePlace place, const PictureSource& source) {
  std::vector<Picture> pictures;
  for (const PictureKind& kind : picture_kinds()) {
    const PicturePlace at = place_of(kind);
    const bool is_here = place == PicturePlace::compared
                             ? compares(at) && kind.scope == PictureScope::file
                             : at == place;
    if (!is_here || !has_picture(kind, source)) {
      continue;
    }
    if (kind.draw_in_parts != nullptr) {
      std::ranges::move(kind.draw_in_parts(source), std::back_inserter(pictures));
    } else {
      pictures.push_back(kind.draw(source));
    }
  }
  return pictures;
}

bool is_broad(const Picture& picture) {
  constexpr double kBroad = 780.0;  // at most 4/3 of half a page [px]
  return picture.view.width() > kBroad;
}

void add_picture(const Picture& picture, const std::string& prefix, Html& html) {
  const char* const size = picture.view.width() <= kShrinking ? "picture shrinks" : "picture";
  html.open("div", {{"class", size}, {"tabindex", "0"}});
  html.markup(svg_element(picture, prefix));
  html.close();
}

void add_figures(const std::vector<Picture>& pictures,
                 const std::string& name,
                 const std::string& id,
                 int& figures,
                 Html& html) {
  for (const Picture& one : pictures) {
    ++figures;
    if (is_broad(one)) {
      html.open("figure", {{"class", "broad"}, {"data-picture", one.name}});
    } else {
      html.open("figure", {{"data-picture", one.name}});
    }
    add_picture(one, fmt::format("{}-figure-{}", id, figures), html);
    add_caption(figures, caption_of(one.title, name), html);
    html.close();
  }
}

}  // namespace kinestat
