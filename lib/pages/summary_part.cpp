// The first screen of a page: the mechanism, moving if it does, and what was found.
#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "pages/figures.hpp"
#include "pages/motion_figure.hpp"
#include "pages/moving_figure.hpp"
#include "pages/page_parts.hpp"
#include "pages/spatial_scene.hpp"
#include "pages/tables.hpp"
#include "studies/motion/report/motion_text.hpp"
#include "studies/synthesis/picture/moving_linkage.hpp"

namespace kinestat {

namespace {

// Of a synthesis the best linkage through its positions; nothing without one.
void add_moving_linkage(SectionWriter& section) {
  const std::optional<MovingLinkage> moving = draw_moving_linkage(*section.page().synthesis, 0);
  if (!moving) {
    return;
  }
  MovingFigure figure{.name = moving->picture.name,
                      .section = section.id() + "-synthesis",
                      .number = ++section.figures(),
                      .caption = caption_of(moving->picture.title, page_title(section.page())),
                      .what = moving->input,
                      .drawn = moving->first,
                      .is_closed = moving->is_closed,
                      .bodies = moving->bodies,
                      .labels = moving->labels,
                      .rows = {},
                      .acting = {},
                      .steps = {}};
  for (const std::vector<PlanePose>& poses : moving->steps) {
    figure.rows.push_back(figure.steps.size());
    figure.steps.emplace_back();
    for (const PlanePose& pose : poses) {
      figure.steps.back().push_back({pose.shift.real(), pose.shift.imag(), pose.angle});
    }
  }
  section.html().open("div");
  open_moving_figure(moving->picture, figure, section.html());
  section.html().close();
  section.html().close();
}

void add_sentences(const std::vector<std::string>& sentences, Html& html) {
  for (const std::string& one : sentences) {
    html.element("p", one);
  }
}

void add_extremes(const TextBlocks& extremes, Html& html) {
  html.open("div", {{"class", "results"}});
  add_blocks(extremes, "Extremes", html);
  html.close();
}

void add_turning_figure(const Picture& picture, SectionWriter& section) {
  Html& html = section.html();
  const int number = ++section.figures();
  const std::string id = fmt::format("{}-figure-{}", section.id(), number);
  html.open("figure", {{"data-picture", picture.name}});
  add_picture(picture, id, html);
  add_caption(number, caption_of(picture.title, page_title(section.page())), html);
  add_spatial_scene(*section.page().analysis, {}, {}, id + "-scene", html);
  html.close();
}

void add_main_figure(const std::optional<Picture>& picture, SectionWriter& section) {
  const FilePage& page = section.page();
  Html& html = section.html();
  if (has_drawn_motion(page)) {
    html.open("div");
    add_motion_figure(*page.analysis,
                      *page.motion,
                      {.name = "motion", .section = section.id_of(ChartRows::of_motion)},
                      section.figures(),
                      html);
    html.close();
  } else if (leads_with_simulation(page)) {
    html.open("div");
    add_simulation_figure(section);
    html.close();
  } else if (picture) {
    html.open("div");
    if (page.analysis->mechanism.space == Space::spatial && picture->name == "linkage") {
      add_turning_figure(*picture, section);
    } else {
      add_figures({*picture}, page_title(page), section.id(), section.figures(), html);
    }
    html.close();
  } else if (page.synthesis) {
    add_moving_linkage(section);
  }
}

}  // namespace

bool has_drawn_motion(const FilePage& page) {
  return page.analysis && page.motion && !page.motion->drawn.positions.empty();
}

void add_summary_part(SectionWriter& section, const std::optional<Picture>& picture) {
  const FilePage& page = section.page();
  Html& html = section.html();
  const std::vector<std::string> results = result_sentences(page);
  const std::vector<std::string> counts = count_sentences(page);
  if (results.empty() && counts.empty()) {
    return;
  }
  section.open_part("summary", "Summary");
  html.open("div", {{"class", "lead"}});
  add_main_figure(picture, section);
  html.open("div", {{"class", "results"}});
  if (page.analysis) {
    add_blocks(overview_blocks(*page.analysis), "Cases", html, TablePlace::beside_picture);
  }
  add_sentences(results, html);
  if (results.empty()) {
    add_sentences(counts, html);
  } else if (!counts.empty()) {
    html.open("details");
    html.element("summary", "Bodies, couplings, mobility");
    add_sentences(counts, html);
    html.close();
  }
  html.close();
  html.close();
  if (page.motion) {
    add_extremes(motion_extremes(page.motion->table), html);
  }
  if (page.simulation) {
    add_extremes(page.simulation->blocks.extremes, html);
  }
  html.close();
}

}  // namespace kinestat
